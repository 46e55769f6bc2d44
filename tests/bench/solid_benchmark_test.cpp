#include "bench/solid_benchmark.h"

#include <gmock/gmock.h>

#include <array>

#include "bench/solid_models.h"
#include "bench/solid_stages.h"
#include "bench/solid_summary.h"
#include "gl/context.h"
#include "materials/solid_registry.h"
#include "shaders/relievo/constants.h"

namespace relievo::bench {
namespace {

using testing::Contains;
using testing::Not;

SolidBenchmarkOptions smallOptions(const std::string& solid, const std::string& shape,
                                   const std::string& printed) {
    SolidBenchmarkOptions options;
    options.solids = {solid};
    options.shapes = {shape};
    options.techniques = {"solid", printed};
    options.steps = {256};
    options.sizes = {128};
    options.frame = 81;
    options.repeat = 1;
    return options;
}

// Shares over all elevations of one technique, with the default budget or with the other one.
struct Shares {
    double behind = 0.0;
    double lost = 0.0;
    double exhausted = 0.0;
    double wrong = 0.0;
};

Shares sharesOf(const SolidReport& report, const std::string& technique, bool isDefault) {
    Shares shares;
    for (const SolidMeasurement& m : report.measurements)
        if (m.technique == technique && m.isDefault == isDefault) {
            shares.behind += m.faults.behind;
            shares.lost += m.faults.lost;
            shares.exhausted += m.errors.unconvergedShare;
            shares.wrong += m.errors.wrongShare;
        }
    return shares;
}

// Ours, with the default budget, is wrong nowhere.
void expectExact(const SolidReport& report) {
    const Shares ours = sharesOf(report, "solid", true);
    EXPECT_EQ(ours.wrong, 0.0);
    EXPECT_EQ(ours.exhausted, 0.0);
}

// The case V' of figure 4.8 in the thesis: steps by the distance to the shape lead into a chamfer
// and out again. More steps do not help.
TEST(SolidBenchmark, ThePrintedSearchPassesThroughLargeChamfers) {
    for (const std::string shape : {"star", "comb"}) {
        SCOPED_TRACE(shape);
        const SolidReport report =
            measureSolids(smallOptions("chamfer-large", shape, "chamfer-printed"));
        expectExact(report);
        EXPECT_GT(sharesOf(report, "chamfer-printed", true).behind, 0.0);
        EXPECT_GT(sharesOf(report, "chamfer-printed", false).behind, 0.0);
    }
}

TEST(SolidBenchmark, ThePrintedSearchPassesThroughBevels) {
    const SolidReport report = measureSolids(smallOptions("bevel", "comb", "bevel-printed"));
    expectExact(report);
    EXPECT_GT(sharesOf(report, "bevel-printed", false).behind, 0.0);
}

// The thesis gives it more steps (its figure 4.19). Steps that lead over the border of a replica
// are wrong with any number of them, where the next one may be nearer.
TEST(SolidBenchmark, ThePrintedSearchLosesRevolutionsBehindTheFirstReplica) {
    for (const std::string shape : {"torus", "vase"}) {
        SCOPED_TRACE(shape);
        SolidBenchmarkOptions options = smallOptions("revolution-10", shape, "revolution-printed");
        const SolidReport centred = measureSolids(options);
        expectExact(centred);
        const double tenReplicas = sharesOf(centred, "revolution-printed", true).exhausted;
        EXPECT_GT(tenReplicas, 0.1);

        options.solids = {"revolution-10-off"};
        options.elevations = {45, 15, 1};
        const SolidReport off = measureSolids(options);
        expectExact(off);
        const Shares printed = sharesOf(off, "revolution-printed", false);
        EXPECT_GT(printed.behind, 0.1);
        EXPECT_GT(printed.lost, 0.0);

        options.solids = {"revolution"};
        options.elevations = {45, 15, 5, 1};
        const SolidReport single = measureSolids(options);
        expectExact(single);
        const Shares one = sharesOf(single, "revolution-printed", true);
        EXPECT_EQ(one.behind, 0.0);
        EXPECT_EQ(one.lost, 0.0);
        EXPECT_LT(one.exhausted, 0.5 * tenReplicas);
    }
}

TEST(SolidBenchmark, ThePrintedSearchRunsOutOfStepsAtLowAngles) {
    SolidBenchmarkOptions options = smallOptions("basic", "comb", "extrusion-printed");
    options.elevations = {5, 1};
    const SolidReport report = measureSolids(options);
    expectExact(report);
    EXPECT_GT(sharesOf(report, "extrusion-printed", true).exhausted, 0.0);
    EXPECT_LT(sharesOf(report, "extrusion-printed", false).exhausted,
              sharesOf(report, "extrusion-printed", true).exhausted);
}

// What is said to have run out of steps is shaded all the same, as printed: streaks, not holes.
TEST(SolidBenchmark, StreaksOfThePrintedSearchAreShaded) {
    const auto context = gl::createContext(gl::Backend::OSMesa);
    viewer::FrameRenderer frames;
    const solids::SolidPart part = makeSolidModel("basic", makeSolidShape("star", 64, false));
    materials::SolidMaterial material(std::make_shared<materials::ShapeTextureCache>(), {{part}},
                                      materials::findSolidTechnique("extrusion-printed"));
    material.setParameter("solid-steps", 2);
    material.low = part.windowMinimum;
    material.high = part.windowMaximum;
    const viewer::SurfaceBuffers surface(surfaces::makeQuad({1.0f, 1.0f}, 1.0f));
    viewer::SceneObject object;
    object.surface = &surface;
    object.solid = &material;
    viewer::FrameView view;
    view.camera = viewer::parallelRays(35.0f, 5.0f, 1.0f);
    const viewer::WorkCounts work = viewer::countWork(frames.measure(object, view, 32, 32));
    EXPECT_GT(work.exhausted, work.pixels / 4);
    const auto holes = [&] {
        gl::Framebuffer target(32, 32, std::array<GLenum, 1>{GL_RGBA8});
        frames.draw({&object, 1}, view, target);
        const std::vector<float> picture = target.read(0);
        std::size_t count = 0;
        for (std::size_t k = 0; k < picture.size(); k += 4)
            count += std::abs(picture[k] - 0.09f) < 0.01f && std::abs(picture[k + 2] - 0.1f) < 0.01f
                         ? 1
                         : 0;
        return count;
    };
    EXPECT_EQ(holes(), 0U);
    material = materials::SolidMaterial(std::make_shared<materials::ShapeTextureCache>(), {{part}},
                                        materials::findSolidTechnique("solid"));
    material.setParameter("solid-steps", 2);
    material.low = part.windowMinimum;
    material.high = part.windowMaximum;
    EXPECT_GT(holes(), 0U);
}

TEST(SolidBenchmark, ReliefsBeginWhereTheSolidDoes) {
    for (const std::string_view solid : solidModelNames()) {
        if (!fitsSolid("star", solid))
            continue;
        SCOPED_TRACE(solid);
        const solids::SolidPart part = makeSolidModel(solid, makeSolidShape("star", 32, false));
        const textures::DepthMap relief = reliefOf(part.solid);
        int slopes = 0;
        for (std::size_t k = 0; k < relief.depth.texels.size(); ++k) {
            const double distance = part.solid.shape->distance.texels[k];
            const double depth = relief.depth.texels[k];
            const auto isInside = [&](double z) {
                return distance <= solids::offsetAt(part.solid.profile, z);
            };
            EXPECT_TRUE(depth <= 1e-5 || !isInside(depth - 1e-5)) << depth;
            EXPECT_TRUE(depth >= 1.0 - 1e-5 || isInside(depth + 1e-5)) << depth;
            slopes += depth > 0.0 && depth < 1.0 ? 1 : 0;
        }
        EXPECT_EQ(slopes > 0, solid != "basic" && solid != "extended");
    }
}

// A frame whose hits are those of the truth, but for what `change` makes of them.
template <typename Change>
SolidErrors errorsOf(const Change& change) {
    constexpr double kTexel = 0.01;
    viewer::MeasuredFrame frame{10, 1, std::vector<viewer::MeasuredPixel>(10)};
    std::vector<RayTruth> truth(10);
    for (std::size_t k = 0; k < 10; ++k) {
        viewer::MeasuredPixel& pixel = frame.pixels[k];
        pixel.covered = true;
        pixel.direction = {0.0f, 0.0f, 1.0f};
        pixel.outcome = RELIEVO_OUTCOME_HIT;
        pixel.t = 0.5f;
        pixel.hit = {0.0f, 0.0f, 0.5f};
        truth[k].exact = {true, false, 0.5};
        truth[k].tied = {truth[k].exact, truth[k].exact};
    }
    change(frame.pixels[0], truth[0]);
    return compareWithSolid(frame, truth, {1.0, 1.0, true}, kTexel);
}

TEST(SolidTruth, FaultsAreToldApart) {
    using viewer::MeasuredPixel;
    const SolidErrors right = errorsOf([](MeasuredPixel&, RayTruth&) {});
    EXPECT_EQ(right.errors.wrongShare, 0.0);
    EXPECT_EQ(right.tiedShare, 0.0);

    const SolidErrors behind = errorsOf([](MeasuredPixel& p, RayTruth&) { p.t = 0.52f; });
    EXPECT_DOUBLE_EQ(behind.errors.wrongShare, 0.1);
    EXPECT_DOUBLE_EQ(behind.faults.behind, 0.1);

    const SolidErrors floor = errorsOf([](MeasuredPixel& p, RayTruth&) {
        p.t = 1.0f;
        p.hit.z = 1.0f;
    });
    EXPECT_DOUBLE_EQ(floor.faults.lost, 0.1);
    EXPECT_EQ(floor.faults.behind, 0.0);

    const SolidErrors miss =
        errorsOf([](MeasuredPixel& p, RayTruth&) { p.outcome = RELIEVO_OUTCOME_MISS; });
    EXPECT_DOUBLE_EQ(miss.faults.lost, 0.1);

    const SolidErrors inFront = errorsOf([](MeasuredPixel& p, RayTruth&) { p.t = 0.48f; });
    EXPECT_DOUBLE_EQ(inFront.faults.inFront, 0.1);

    const SolidErrors exhausted =
        errorsOf([](MeasuredPixel& p, RayTruth&) { p.outcome = RELIEVO_OUTCOME_EXHAUSTED; });
    EXPECT_DOUBLE_EQ(exhausted.errors.wrongShare, 0.1);
    EXPECT_DOUBLE_EQ(exhausted.errors.unconvergedShare, 0.1);
    EXPECT_EQ(exhausted.faults.lost, 0.0);
    EXPECT_EQ(exhausted.faults.inFront, 0.0);

    const auto tie = [](MeasuredPixel& p, RayTruth& truth) {
        p.t = 0.9f;
        truth.tied[1] = {true, false, 0.9};
    };
    EXPECT_EQ(errorsOf(tie).errors.wrongShare, 0.0);
    EXPECT_DOUBLE_EQ(errorsOf(tie).tiedShare, 0.1);
}

// A level ray above a level surface, by less and by more than a thousandth of a texel.
TEST(SolidTruth, RaysThatOnlyRoundingDecidesAreTied) {
    constexpr int kSize = 16;
    auto shape = std::make_shared<textures::ShapeMap>();
    shape->wrap = textures::WrapMode::Clamp;
    shape->distance = textures::Plane(kSize, kSize);
    for (int j = 0; j < kSize; ++j)
        for (int i = 0; i < kSize; ++i)
            shape->distance.at(i, j) = 0.5f - (static_cast<float>(j) + 0.5f) / kSize;
    const SolidTruth truth(makeSolidModel("revolution", shape));
    const auto hits = [&](double texelsAbove) {
        viewer::MeasuredFrame frame{1, 1, std::vector<viewer::MeasuredPixel>(1)};
        frame.pixels[0].covered = true;
        frame.pixels[0].origin = {0.0f, 0.5f, static_cast<float>(0.5 - texelsAbove / kSize)};
        frame.pixels[0].direction = {1.0f, 0.0f, 0.0f};
        const RayTruth ray = truth.trace(frame, {}).at(0);
        return std::array{ray.exact.exists, ray.tied[0].exists, ray.tied[1].exists};
    };
    EXPECT_EQ(hits(0.5), (std::array{false, false, false}));
    EXPECT_EQ(hits(0.5 * kSolidTie), (std::array{false, true, false}));
    EXPECT_EQ(hits(-0.5 * kSolidTie), (std::array{true, true, false}));
    EXPECT_EQ(hits(-0.5), (std::array{true, true, true}));
}

SolidMeasurement measurement(double fetches, double wrongShare) {
    SolidMeasurement result;
    result.work.meanFetches = fetches;
    result.errors.wrongShare = wrongShare;
    return result;
}

TEST(SolidSummary, FetchesAreComparedAtTheOtherSearchsLeastError) {
    const std::vector<SolidMeasurement> theirs{measurement(10, 0.5), measurement(20, 0.1),
                                               measurement(40, 0.1), measurement(80, 0.101)};
    const std::vector<SolidMeasurement> ours{measurement(2, 0.6), measurement(4, 0.08),
                                             measurement(6, 0.0)};
    EXPECT_DOUBLE_EQ(fetchesAtEqualError(ours, theirs).value_or(0.0), 4.0 / 20.0);
    EXPECT_DOUBLE_EQ(fetchesAtEqualError(ours, {measurement(30, 0.0)}).value_or(0.0), 6.0 / 30.0);
    EXPECT_EQ(fetchesAtEqualError({measurement(2, 0.2)}, theirs), std::nullopt);
}

TEST(SolidSummary, FetchesAreComparedWithinAnError) {
    const std::vector<SolidMeasurement> theirs{measurement(10, 0.5), measurement(20, 0.1),
                                               measurement(40, 0.05)};
    const std::vector<SolidMeasurement> ours{measurement(2, 0.6), measurement(4, 0.08)};
    EXPECT_DOUBLE_EQ(fetchesWithin(ours, theirs, 0.1).value_or(0.0), 4.0 / 20.0);
    EXPECT_DOUBLE_EQ(fetchesWithin(ours, theirs, 0.7).value_or(0.0), 2.0 / 10.0);
    EXPECT_EQ(fetchesWithin(ours, theirs, 0.04), std::nullopt);
    EXPECT_GT(fetchesWithin(ours, theirs, 0.06).value_or(0.0), 1e300);
}

TEST(SolidBenchmark, HasARowForEverySearchThatShowsTheSolid) {
    SolidBenchmarkOptions options;
    options.solids = {"chamfer", "revolution"};
    options.shapes = {"annulus", "vase"};
    options.techniques = solidBenchmarkTechniques();
    options.steps = {8};
    options.elevations = {45};
    options.sizes = {16, 17};
    options.frame = 9;
    options.repeat = 1;
    const SolidReport report = measureSolids(options);
    // With 8 steps and with the default: for each size ours twice, a printed one each, five
    // reliefs.
    EXPECT_EQ(report.measurements.size(), 2U * (2 * (1 + 1 + 5) + 2 * (1 + 1)));
    std::vector<std::string> names;
    for (const SolidMeasurement& m : report.measurements)
        names.push_back(m.solid + " " + m.technique);
    EXPECT_THAT(names, Contains("chamfer chamfer-printed"));
    EXPECT_THAT(names, Contains("chamfer cone-step"));
    EXPECT_THAT(names, Not(Contains("chamfer bevel-printed")));
    EXPECT_THAT(names, Contains("revolution revolution-printed"));
    EXPECT_THAT(names, Not(Contains("revolution relief")));
}

}  // namespace
}  // namespace relievo::bench
