// The techniques `exact` and `pyramid` against the double-precision tracer: no wrong first hit
// beyond what the rounding of floats explains, on every sample relief, under every wrap mode, from
// straight above down to a tenth of a degree.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "materials/technique_registry.h"
#include "preprocess/relief_baker.h"
#include "reference/bilinear_tracer.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

constexpr const char* kExactTechniques[] = {"exact", "pyramid"};
constexpr float kElevations[] = {90.0f, 45.0f, 15.0f, 5.0f, 1.0f, 0.1f};
constexpr float kAzimuths[] = {0.0f, 30.0f, 135.0f, 261.0f};

int frameSize() {
    const char* const size = std::getenv("RELIEVO_FRAME_SIZE");
    return size == nullptr ? 48 : std::stoi(size);
}

textures::MapSet bakeRoofs(const textures::DepthMap& map, int sectors) {
    preprocess::ReliefPlan plan;
    plan.cone = "roof";
    plan.sectors = sectors;
    return preprocess::bakeRelief(map, plan);
}

// The steepest step from a texel to one of its neighbours.
double steepestStep(const textures::DepthMap& map) {
    float steepest = 0.0f;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i)
            steepest = std::max({steepest, std::abs(map.at(i + 1, j) - map.at(i, j)),
                                 std::abs(map.at(i, j + 1) - map.at(i, j))});
    return static_cast<double>(steepest);
}

// What floats may have done to a hit. A product of t and a speed in texels rounds by 2⁻²⁴ of the
// texels that the ray has gone, and so do t itself and the sum with the start: a quarter of 2⁻²⁰ in
// all, along both axes; and as much of a texel for the fraction. On the steepest slope of the map
// that is as much depth as the ray may seem higher or lower than it is; depths themselves, of at
// most 1, take eight roundings more.
struct Rounding {
    double texels;
    double depth;
};

Rounding roundingAt(double texelsGone, double steepest) {
    const double texels = 0x1p-22 * (texelsGone + 1.0);
    return {texels, texels * steepest + 0x1p-21};
}

// Where a ray first meets the relief when all of it lies `lower` deeper; infinity when it does not.
double meets(const textures::DepthMap& map, reference::TileRay ray, double lower) {
    ray.origin.z -= lower;
    const auto hit = reference::traceBilinear(map, ray);
    return hit ? hit->t : std::numeric_limits<double>::infinity();
}

// A hit is right when it is not before the one on a relief that is higher by the rounding, nor
// after the one on a relief that is lower by it. Near a tangent that may be a long way; elsewhere
// it is nothing that can be seen.
bool isRight(const MeasuredPixel& pixel, const textures::DepthMap& map, double steepest) {
    if (pixel.outcome != RELIEVO_OUTCOME_HIT)
        return false;
    const reference::TileRay ray{glm::dvec3(pixel.origin), glm::dvec3(pixel.direction)};
    const double t = pixel.t;
    const double speed = map.width() * std::hypot(ray.direction.x, map.aspect() * ray.direction.y);
    const Rounding rounding = roundingAt(t * speed, steepest);
    const double slack = (1.0 + t) * 0x1p-22 + rounding.texels / std::max(speed, 1.0);
    return t >= meets(map, ray, -rounding.depth) - slack &&
           t <= meets(map, ray, rounding.depth) + slack;
}

struct Tally {
    std::size_t rays = 0;
    std::size_t wrong = 0;
    double fetches = 0.0;
};

Tally tally(const textures::MapSet& maps, const char* technique) {
    SCOPED_TRACE(technique);
    const textures::DepthMap map = textures::depthMapOf(maps);
    const double steepest = steepestStep(map);
    RayScene scene(maps, 0.0f, 90.0f);
    materials::ReliefMaterial material =
        scene.renderer.makeMaterial(materials::findTechnique(technique));
    Tally result;
    for (const float elevation : kElevations)
        for (const float azimuth : kAzimuths) {
            scene.look(azimuth, elevation);
            const MeasuredFrame frame =
                scene.renderer.measure(material, scene.view, frameSize(), frameSize());
            std::atomic<std::size_t> wrong = 0;
            tbb::parallel_for(std::size_t{0}, frame.pixels.size(), [&](std::size_t k) {
                if (!isRight(frame.pixels[k], map, steepest))
                    ++wrong;
            });
            const WorkCounts work = countWork(frame);
            EXPECT_EQ(work.pixels, frame.pixels.size());
            EXPECT_EQ(wrong, 0u) << "elevation " << elevation << ", azimuth " << azimuth;
            result.rays += work.pixels;
            result.wrong += wrong;
            result.fetches += work.meanFetches * static_cast<double>(work.pixels);
        }
    return result;
}

textures::DepthMap sampleRelief(std::string_view name, int width, int height,
                                textures::WrapMode wrap) {
    textures::DepthMap map = textures::generateSampleRelief(name, width, height);
    map.wrap = wrap;
    return map;
}

class ExactHits : public testing::TestWithParam<const textures::SampleRelief*> {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

TEST_P(ExactHits, AreTheFirstOnesUnderEveryWrapMode) {
    for (const textures::WrapMode wrap :
         {textures::WrapMode::Repeat, textures::WrapMode::Mirror, textures::WrapMode::Clamp}) {
        SCOPED_TRACE(testing::Message() << "wrap " << static_cast<int>(wrap));
        const textures::MapSet maps = bakeRoofs(sampleRelief(GetParam()->name, 128, 128, wrap), 4);
        for (const char* technique : kExactTechniques) {
            const Tally found = tally(maps, technique);
            fmt::print("{:12} wrap {} {:8} {} rays, {} wrong, {:.1f} fetches a ray\n",
                       GetParam()->name, static_cast<int>(wrap), technique, found.rays, found.wrong,
                       found.fetches / static_cast<double>(found.rays));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, ExactHits, testing::ValuesIn(everySample()),
                         nameOfTest<textures::SampleRelief>);

class ExactHitsOf : public testing::Test {
  protected:
    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

TEST_F(ExactHitsOf, EveryNumberOfSectorsAndShapeOfMap) {
    for (const textures::WrapMode wrap :
         {textures::WrapMode::Repeat, textures::WrapMode::Mirror, textures::WrapMode::Clamp})
        for (const int sectors : {1, 4, 8})
            for (const auto& [width, height] : {std::pair(61, 37), std::pair(16, 128)}) {
                SCOPED_TRACE(testing::Message()
                             << "wrap " << static_cast<int>(wrap) << ", " << sectors << " sectors, "
                             << width << "×" << height);
                const textures::MapSet maps =
                    bakeRoofs(sampleRelief("lettering", width, height, wrap), sectors);
                tally(maps, "exact");
                if (sectors == 1)
                    tally(maps, "pyramid");
            }
}

TEST_F(ExactHitsOf, MapsOfOneTexelOrOneRow) {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 16), std::pair(16, 1)})
        for (const textures::WrapMode wrap :
             {textures::WrapMode::Repeat, textures::WrapMode::Mirror, textures::WrapMode::Clamp}) {
            SCOPED_TRACE(testing::Message()
                         << width << "×" << height << ", wrap " << static_cast<int>(wrap));
            for (const char* technique : kExactTechniques)
                tally(bakeRoofs(sampleRelief("noise", width, height, wrap), 4), technique);
        }
}

// Cones half as wide again, and roofs a little too deep, are found out.
TEST_F(ExactHitsOf, UnsafeMapsAreWrong) {
    const textures::DepthMap map = sampleRelief("lettering", 128, 128, textures::WrapMode::Repeat);
    for (const std::string channel : {"ratio", "roof"}) {
        textures::MapSet maps = bakeRoofs(map, 4);
        for (textures::Channel& plane : maps.channels)
            if (plane.name.starts_with(channel))
                for (float& value : plane.plane.texels)
                    value = channel == "roof" ? value + 0.05f : 1.5f * value;
        const double steepest = steepestStep(map);
        RayScene scene(maps, 30.0f, 5.0f);
        materials::ReliefMaterial material =
            scene.renderer.makeMaterial(materials::findTechnique("exact"));
        const MeasuredFrame frame = scene.renderer.measure(material, scene.view, 48, 48);
        std::size_t wrong = 0;
        for (const MeasuredPixel& pixel : frame.pixels)
            wrong += isRight(pixel, map, steepest) ? 0 : 1;
        EXPECT_GT(wrong, frame.pixels.size() / 100) << channel;
    }
}

}  // namespace
}  // namespace relievo::viewer
