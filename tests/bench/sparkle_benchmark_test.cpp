// A receding plane under a slowly turning camera: MIP levels and rays along the footprint of a
// pixel keep it still, and do not change what is seen.
#include "bench/sparkle_benchmark.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relievo::bench {
namespace {

SparkleBenchmarkOptions smallOptions() {
    SparkleBenchmarkOptions options;
    options.samples = {"noise", "cobbles", "bricks", "lettering"};
    options.techniques = {"exact"};
    options.frames = 4;
    options.supersampling = 5;
    return options;
}

double variance(const SparkleMeasurement& measurement) {
    return measurement.errors.sparkle * measurement.errors.sparkle;
}

// Per relief: one ray without levels, with levels, then several rays without and with them, which
// is what a picture has when nothing is asked for.
TEST(Sparkle, GoesAwayByDefaultOnEveryRelief) {
    const SparkleReport report = measureSparkle(smallOptions());
    ASSERT_EQ(report.measurements.size(), 16u);
    for (std::size_t k = 0; k < report.measurements.size(); k += 4) {
        const SparkleMeasurement* const way = &report.measurements[k];
        SCOPED_TRACE(way->sample);
        EXPECT_LT(variance(way[3]), 0.18 * variance(way[0])) << "both";
        EXPECT_LT(std::abs(way[3].errors.bias), 0.0035);
        EXPECT_LT(way[3].errors.lasting, way[0].errors.lasting);
        // Levels alone, with a ray in the middle of each pixel, do not do it.
        EXPECT_GT(variance(way[1]), 0.5 * variance(way[0])) << "levels";
    }
}

// Where a pixel covers whole tiles a few rays are not enough, and levels are.
TEST(Sparkle, GoesAwayFarAwayWithLevels) {
    SparkleBenchmarkOptions options = smallOptions();
    options.tiles = 4096;
    options.frame = 64;
    const SparkleReport report = measureSparkle(options);
    for (std::size_t k = 0; k < report.measurements.size(); k += 4) {
        const SparkleMeasurement* const way = &report.measurements[k];
        SCOPED_TRACE(way->sample);
        EXPECT_GT(variance(way[2]), 0.2 * variance(way[0])) << "several rays";
        EXPECT_LT(variance(way[3]), 0.1 * variance(way[0])) << "both";
    }
}

viewer::Picture flatPicture(float value) {
    viewer::Picture picture(4, 4);
    for (float& number : picture.rgba)
        number = value;
    return picture;
}

// What the statistics tell apart: a picture that is wrong all the time, and one that comes and
// goes.
TEST(TemporalError, TellsWhatStaysFromWhatComesAndGoes) {
    viewer::TemporalError steady;
    viewer::TemporalError changing;
    for (int frame = 0; frame < 4; ++frame) {
        steady.add(flatPicture(1.0f), flatPicture(0.0f));
        changing.add(flatPicture(frame % 2 == 0 ? 1.0f : 0.0f), flatPicture(0.0f));
    }
    EXPECT_NEAR(steady.statistics().sparkle, 0.0, 1e-12);
    EXPECT_NEAR(steady.statistics().lasting, 1.0, 1e-6);
    EXPECT_NEAR(steady.statistics().bias, 1.0, 1e-6);
    // Of 1, 0, 1, 0 the sample variance is 1/3.
    EXPECT_NEAR(changing.statistics().sparkle, std::sqrt(1.0 / 3.0), 1e-6);
    EXPECT_NEAR(changing.statistics().bias, 0.5, 1e-6);
}

// Averages are of light, not of its encoding: half white, half black is 0.735 in sRGB.
TEST(TemporalError, PicturesAreAveragedInLinearLight) {
    viewer::Picture fine(2, 2);
    for (int c = 0; c < 4; ++c)
        fine.pixel(0, 0)[c] = fine.pixel(1, 1)[c] = 1.0f;
    const viewer::Picture mean = viewer::averaged(fine, 2);
    EXPECT_NEAR(viewer::luminance(mean.pixel(0, 0)), 0.5, 1e-6);
    EXPECT_NEAR(mean.pixel(0, 0)[0], 0.7354f, 1e-3f);
}

}  // namespace
}  // namespace relievo::bench
