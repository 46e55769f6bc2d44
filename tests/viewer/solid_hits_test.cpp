// The search of solids against the double-precision tracer: no wrong first hit beyond what the
// rounding of floats explains, of extrusions of every profile, revolutions and compounds, seen from
// straight above down to level rays, from below and from inside. The environment variable
// RELIEVO_FRAME_SIZE makes the frames larger: docs/measurements.md has the figures of 10⁷ rays.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <cstdlib>
#include <string>

#include "shaders/relievo/constants.h"
#include "solid_rounding.h"
#include "solid_samples.h"
#include "solid_scene.h"

namespace relievo::viewer {
namespace {

int frameSize() {
    const char* const size = std::getenv("RELIEVO_FRAME_SIZE");
    return size == nullptr ? 12 : std::stoi(size);
}

struct Tally {
    std::size_t rays = 0;
    std::size_t hits = 0;
    std::size_t wrong = 0;
    std::size_t tangents = 0;
    std::size_t exhausted = 0;
    double worst = 0.0;  // texels
    double steps = 0.0;
    double fetches = 0.0;

    Tally& operator+=(const Tally& other) {
        rays += other.rays;
        hits += other.hits;
        wrong += other.wrong;
        tangents += other.tangents;
        exhausted += other.exhausted;
        worst = std::max(worst, other.worst);
        steps += other.steps;
        fetches += other.fetches;
        return *this;
    }
};

void report(const MeasuredPixel& pixel, const SolidRounding& rounding) {
    const auto hit = rounding.exact().firstHit(rayOf(pixel));
    fmt::print(
        "wrong: outcome {} t {:.9g}, exact {:.9g}, steps {}, from ({:.9g}, {:.9g}, {:.9g}) "
        "along ({:.9g}, {:.9g}, {:.9g}) to {:.9g}\n",
        pixel.outcome, pixel.t, hit ? hit->t : -1.0, pixel.steps, pixel.origin.x, pixel.origin.y,
        pixel.origin.z, pixel.direction.x, pixel.direction.y, pixel.direction.z, pixel.end);
}

Tally tally(const MeasuredFrame& frame, const SolidRounding& rounding) {
    tbb::combinable<Tally> tallies;
    tbb::parallel_for(std::size_t{0}, frame.pixels.size(), [&](std::size_t k) {
        const MeasuredPixel& pixel = frame.pixels[k];
        if (!pixel.covered)
            return;
        Tally one;
        one.rays = 1;
        one.steps = pixel.steps;
        one.fetches = pixel.fetches;
        one.hits = pixel.outcome == RELIEVO_OUTCOME_HIT;
        one.exhausted = pixel.outcome == RELIEVO_OUTCOME_EXHAUSTED;
        if (one.exhausted == 0) {
            const SolidVerdict verdict = rounding.judge(pixel);
            one.wrong = verdict.isRight ? 0 : 1;
            one.tangents = verdict.isRight && verdict.isTangent;
            one.worst = verdict.isRight ? verdict.deviation : 0.0;
        }
        tallies.local() += one;
    });
    Tally sum;
    tallies.combine_each([&](const Tally& one) { sum += one; });
    if (sum.wrong + sum.exhausted > 0) {
        int shown = 0;
        for (const MeasuredPixel& pixel : frame.pixels)
            if (pixel.covered && !rounding.judge(pixel).isRight && ++shown <= 2)
                report(pixel, rounding);
    }
    return sum;
}

void printRow(const std::string& name, const Tally& sum) {
    const auto rays = static_cast<double>(std::max<std::size_t>(sum.rays, 1));
    fmt::print("| {} | {} | {} | {} | {:.2g} | {} | {} | {:.1f} | {:.1f} |\n", name, sum.rays,
               sum.hits, sum.wrong, sum.worst, sum.tangents, sum.exhausted, sum.steps / rays,
               sum.fetches / rays);
}

class SolidHits : public testing::Test {
  protected:
    static void SetUpTestSuite() { stage_ = std::make_unique<SolidStage>(); }
    static void TearDownTestSuite() {
        printRow("all", all_);
        // Of the rays of all tests together.
        EXPECT_LE(static_cast<double>(all_.exhausted), 1e-5 * static_cast<double>(all_.rays));
        stage_.reset();
    }

    static void expectFirstHits(const std::vector<SolidCase>& cases) {
        fmt::print(
            "| solid | rays | hits | wrong | off by, texels | tangent | exhausted | steps | "
            "lookups |\n"
            "|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
        for (const SolidCase& solid : cases) {
            SolidScene scene(*stage_, solid);
            const SolidRounding rounding(solid.compound);
            Tally sum;
            for (const Camera& camera : scene.cameras())
                sum += tally(scene.measure(camera, frameSize()), rounding);
            printRow(solid.name, sum);
            EXPECT_EQ(sum.wrong, 0u) << solid.name;
            EXPECT_GT(sum.rays, 0u) << solid.name;
            all_ += sum;
        }
    }

    static inline std::unique_ptr<SolidStage> stage_;
    static inline Tally all_;
};

TEST_F(SolidHits, OfExtrusionsAreTheFirstOnes) {
    expectFirstHits(extrusionCases());
}

TEST_F(SolidHits, OfRevolutionsAreTheFirstOnes) {
    expectFirstHits(revolutionCases());
}

TEST_F(SolidHits, OfCompoundsAreTheFirstOnes) {
    expectFirstHits(compoundCases());
}

}  // namespace
}  // namespace relievo::viewer
