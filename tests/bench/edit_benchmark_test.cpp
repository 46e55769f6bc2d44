#include "bench/edit_benchmark.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace relievo::bench {
namespace {

EditBenchmarkOptions smallOptions() {
    EditBenchmarkOptions options;
    options.samples = {"noise", "wave"};
    options.size = 96;
    options.strokes = 11;
    options.strokeSize = 8;
    return options;
}

// Also that no stroke leaves cones other than a new build: measureEdits throws then.
TEST(EditBenchmark, HasARowABrushAndOneForUndoing) {
    const std::vector<EditMeasurement> rows = measureEdits(smallOptions());
    ASSERT_EQ(rows.size(), 2u * 6u);
    for (const EditMeasurement& row : rows) {
        EXPECT_EQ(row.size, 96);
        EXPECT_EQ(row.strokes, row.brush == "heap" ? 3 : row.brush == "undo" ? 11 : 2) << row.brush;
        EXPECT_GT(row.meanSeconds, 0.0);
        EXPECT_LE(row.meanSeconds, row.worstSeconds);
        EXPECT_GT(row.buildSeconds, 0.0);
        EXPECT_GT(row.meanTexels, 0.0) << row.brush;
        EXPECT_LE(row.meanTexels, static_cast<double>(row.mostTexels));
        EXPECT_LE(row.mostTexels, 96 * 96);
    }
}

TEST(EditBenchmark, BuildsTheSameTexelsOnAnyNumberOfThreadsAndOthersElsewhere) {
    EditBenchmarkOptions options = smallOptions();
    const auto texels = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<double> means;
        for (const EditMeasurement& row : measureEdits(options))
            means.push_back(row.meanTexels);
        return means;
    };
    const std::vector<double> one = texels(1);
    EXPECT_EQ(texels(2), one);
    options.seed = 2;
    EXPECT_NE(texels(1), one);
}

TEST(EditBenchmark, StrokesAreNoLargerThanTheRelief) {
    EditBenchmarkOptions options = smallOptions();
    options.samples = {"blocks"};
    options.size = 5;
    options.strokes = 5;
    for (const EditMeasurement& row : measureEdits(options))
        EXPECT_LE(row.mostTexels, 25);
}

TEST(EditBenchmark, TableHasEveryMeasurement) {
    const EditMeasurement row{"noise", "heap", 64, 2, 0.001, 0.002, 0.04, 300.0, 350};
    EXPECT_EQ(formatTable(editTable({row})),
              "sample  brush  size  strokes  mean ms  worst ms  all anew ms  mean share  "
              "worst share  mean texels  most texels\n"
              "noise   heap     64        2        1         2           40       0.025  "
              "       0.05          300          350");
}

}  // namespace
}  // namespace relievo::bench
