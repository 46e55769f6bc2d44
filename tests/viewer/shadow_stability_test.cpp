// No shadow method may produce a NaN, a share of the light that is none, or an unbounded search,
// for any light, place, scale or map. How often lights that are points are wrongly let through or
// held back is printed as a table. The environment variable RELIEVO_FRAME_SIZE makes the frames
// larger.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/technique_maps.h"
#include "hostile_rays.h"
#include "materials/shadow_registry.h"
#include "preprocess/relief_baker.h"
#include "reference/visibility.h"
#include "relief_scene.h"

namespace relievo::viewer {
namespace {

int frameSize() {
    const char* const size = std::getenv("RELIEVO_FRAME_SIZE");
    return size == nullptr ? 14 : std::stoi(size);
}

constexpr float kDepthScales[] = {0.0f, 1e-6f, 0.1f, 1.0f, 1e3f};
constexpr float kRadii[] = {0.0f, 0.0044f, 0.1f, 0.7f};  // radians: a point, the sun, lamps

// A shadow method, with a technique that follows its light rays or none that matters.
struct LitTechnique {
    const materials::ShadowMethod* method;
    const materials::Technique* technique;
};

// Every method by exact hits, and the one that is a single light ray by every search.
std::vector<LitTechnique> everyLitTechnique() {
    std::vector<LitTechnique> result;
    for (const materials::ShadowMethod& method : materials::shadowMethods())
        for (const materials::Technique* technique : everyTechnique())
            if (technique->name == "exact" || (method.name == "search" && technique->isSearch))
                result.push_back({&method, technique});
    return result;
}

std::string nameOf(const LitTechnique& lit) {
    return fmt::format("{}{}", lit.method->name,
                       lit.method->searches ? fmt::format(" by {}", lit.technique->name) : "");
}

// Along each light ray cells are looked at until it is clear of the surface, four depths each; the
// search then takes a bounded number of steps, none of them with more lookups than this.
constexpr int kMostLookupsOfAStep = 16;

double mostFetches(const materials::ReliefMaterial& material, const textures::DepthMap& map) {
    const materials::ShadowMethod& method = *material.shadow();
    if (!method.searches)
        return 4.0;
    double steps = 1.0;
    for (const materials::TechniqueParameter& parameter : material.technique().parameters)
        if (parameter.isInteger)
            steps += material.parameter(parameter.name);
    const double search = 4.0 * (map.width() + map.height() + 1) + kMostLookupsOfAStep * steps;
    return method.name == "soft" ? search * material.parameter("shadow-slices") *
                                       (material.parameter("shadow-halvings") + 2.0)
                                 : search;
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isSound(const MeasuredPixel& pixel, double mostFetches) {
    return isFinite(pixel.light) && isFinite(pixel.lift) && isFinite(pixel.side) &&
           pixel.lightShare >= 0.0f && pixel.lightShare <= 1.0f &&
           pixel.shadowFetches <= mostFetches;
}

// What a light ray must rise on a tile's width to be told from a level one on a level relief: of
// horizons and ellipses, more than they are off there.
float leastRise(const materials::ReliefMaterial& material) {
    if (material.shadow()->name == "ellipse")
        return 0.1f;
    return material.shadow()->searches ? 0.0f : 1e-5f;
}

// What holds of any relief: a point of light is there or not, below the surface it is not; and
// nothing shadows a level relief.
bool isRight(const MeasuredPixel& pixel, bool isLevel, float radius, float leastRise) {
    if (radius > 0.0f)
        return true;
    if (pixel.light.z >= 0.0f)
        return pixel.lightShare == 0.0f;
    const bool mustBeLit = isLevel && -pixel.light.z > leastRise;
    return pixel.lightShare == 1.0f || (pixel.lightShare == 0.0f && !mustBeLit);
}

bool isLevel(const textures::DepthMap& map) {
    return std::ranges::all_of(map.depth.texels,
                               [&](float depth) { return depth == map.depth.texels.front(); });
}

// Which points of light are seen, in double precision: the same for all methods.
const std::vector<bool>& exactlyLit(const MeasuredFrame& frame, const HostileMap& hostile,
                                    float depthScale) {
    static std::map<std::pair<std::string_view, float>, std::vector<bool>> all;
    std::vector<bool>& lit = all[{hostile.name, depthScale}];
    if (lit.empty())
        for (const MeasuredPixel& pixel : frame.pixels)
            lit.push_back(reference::isLit(
                hostile.map,
                {static_cast<double>(pixel.origin.x), static_cast<double>(pixel.origin.y)},
                glm::dvec3(pixel.light)));
    return lit;
}

// Points of light that are wrong, of those in a regime.
struct RegimeErrors {
    int points = 0;
    int wrong = 0;
};
using ErrorRows = std::map<std::string, std::vector<RegimeErrors>>;

// A table of Markdown, a row for each method and technique that was tested.
void printTable(const ErrorRows& rows) {
    std::string rule;
    fmt::print("| method |");
    for (const HostileRegime& regime : hostileRegimes()) {
        fmt::print(" {} |", regime.name);
        rule += "---:|";
    }
    fmt::print("\n|---|{}\n", rule);
    for (const auto& [name, row] : rows) {
        fmt::print("| {} |", name);
        for (const RegimeErrors& errors : row)
            fmt::print(" {:.3g} |", 100.0 * errors.wrong / std::max(errors.points, 1));
        fmt::print("\n");
    }
}

bool isSure(const materials::Technique& technique) {
    for (const std::string_view name : {"exact", "pyramid", "cone", "relaxed"})
        if (technique.name == name)
            return true;
    return false;
}

class ShadowStability : public testing::TestWithParam<LitTechnique> {
  protected:
    static void TearDownTestSuite() { printTable(rows_); }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    static inline ErrorRows rows_;
};

TEST_P(ShadowStability, HostileLightsAndMaps) {
    const auto& [method, technique] = GetParam();
    HostileFrame hostileFrame(frameSize());
    std::vector<RegimeErrors> row(hostileRegimes().size());
    for (const HostileMap& hostile : hostileMaps()) {
        const auto maps = std::make_shared<materials::ReliefMaps>(
            preprocess::bakeRelief(hostile.map, bench::planFor(*technique, method)),
            std::string(hostile.name));
        materials::ReliefMaterial material(maps, *technique);
        material.setShadow(method);
        if (method->name == "soft")
            material.setParameter("shadow-slices", 6);  // whose borders round beyond the disc
        gl::Program program = hostileLightProgram(material);
        const bool level = isLevel(hostile.map);
        for (const float scale : kDepthScales)
            for (const float radius : kRadii) {
                SCOPED_TRACE(
                    fmt::format("{}, depth scale {}, radius {}", hostile.name, scale, radius));
                material.depthScale = scale;
                const MeasuredFrame frame = hostileFrame.light(material, program, radius);
                for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
                    const MeasuredPixel& pixel = frame.pixels[k];
                    ASSERT_TRUE(pixel.covered &&
                                isSound(pixel, mostFetches(material, hostile.map)) &&
                                isRight(pixel, level, radius, leastRise(material)))
                        << "ray " << k << ", " << hostileRegimes()[regimeOfRay(k)].name
                        << ", light " << pixel.light.x << ", " << pixel.light.y << ", "
                        << pixel.light.z << ", share " << pixel.lightShare << ", lookups "
                        << pixel.shadowFetches;
                    if (radius > 0.0f)
                        continue;
                    RegimeErrors& errors = row[regimeOfRay(k)];
                    ++errors.points;
                    errors.wrong +=
                        exactlyLit(frame, hostile, scale)[k] != (pixel.lightShare > 0.5f);
                }
            }
    }
    rows_[nameOf(GetParam())] = row;
    if (!method->searches || !isSure(*technique))
        return;
    // What is left: light that is level for floats, and steps that run out on the way to it.
    for (std::size_t k = 0; k < row.size(); ++k)
        EXPECT_LE(row[k].wrong, 0.025 * row[k].points) << hostileRegimes()[k].name;
}

INSTANTIATE_TEST_SUITE_P(Methods, ShadowStability, testing::ValuesIn(everyLitTechnique()),
                         [](const testing::TestParamInfo<LitTechnique>& test) {
                             std::string name = nameOf(test.param);
                             std::ranges::replace_if(
                                 name, [](char c) { return c == '-' || c == ' '; }, '_');
                             return name;
                         });

// What the test above looks for, it would find.
TEST(ShadowSoundness, SeesWhatIsWrong) {
    MeasuredPixel lit;
    lit.light = {0, 0, -1};
    lit.lightShare = 1.0f;
    lit.shadowFetches = 5;
    ASSERT_TRUE(isSound(lit, 5.0) && isRight(lit, true, 0.0f, 1e-5f));
    const auto broken = [&](const auto& breakIt) {
        MeasuredPixel pixel = lit;
        breakIt(pixel);
        return !isSound(pixel, 5.0) || !isRight(pixel, true, 0.0f, 1e-5f);
    };
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.lightShare = std::nanf(""); }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.lightShare = 1.001f; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.lightShare = -0.001f; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.lightShare = 0.5f; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.lightShare = 0.0f; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.light.z = 0.5f; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.light.x = HUGE_VALF; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.lift.x = std::nanf(""); }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.side.z = HUGE_VALF; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.shadowFetches = 6; }));
}

}  // namespace
}  // namespace relievo::viewer
