// No technique may produce a NaN, an infinity, an unbounded search or a hit outside the relief or
// its window, for any ray, scale, place or map. How far its hits are off for such rays is printed
// as a table. The environment variable RELIEVO_FRAME_SIZE makes the frames larger: 160 is over a
// million rays for each technique.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <string>

#include "float_rounding.h"
#include "hostile_rays.h"
#include "materials/technique_registry.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/bilinear.h"
#include "viewer/reference_frame.h"

namespace relievo::viewer {
namespace {

int frameSize() {
    const char* const size = std::getenv("RELIEVO_FRAME_SIZE");
    return size == nullptr ? 14 : std::stoi(size);
}

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr glm::vec4 kEverywhere{-kInfinity, -kInfinity, kInfinity, kInfinity};
// Some of the rays begin outside, some leave it through each side.
constexpr glm::vec4 kWindow{-1.5f, -0.75f, 2.25f, 1.0f};
constexpr float kDepthScales[] = {0.0f, 1e-6f, 0.1f, 1.0f, 1e3f};

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// No search takes more steps than its parameters, the numbers of steps of each kind, allow; and one
// step needs no parameter.
double mostSteps(const materials::ReliefMaterial& material) {
    double steps = 1.0;
    for (const materials::TechniqueParameter& parameter : material.technique().parameters)
        if (parameter.isInteger)
            steps += material.parameter(parameter.name);
    return steps;
}

// Depths up to what rounding makes of the end of a ray.
bool isWithin(const glm::vec4& window, const glm::vec3& point) {
    return point.x >= window.x && point.y >= window.y && point.x <= window.z &&
           point.y <= window.w && point.z >= -1e-6f && point.z <= 1.001f;
}

bool isSound(const MeasuredPixel& pixel, double mostSteps, const glm::vec4& window) {
    const bool isBounded = pixel.steps <= mostSteps && pixel.t >= 0.0f;
    return isFinite(pixel.hit) && std::isfinite(pixel.t) && isFinite(pixel.normal) && isBounded &&
           (pixel.outcome == RELIEVO_OUTCOME_HIT ? isWithin(window, pixel.hit)
                                                 : pixel.outcome == RELIEVO_OUTCOME_MISS ||
                                                       pixel.outcome == RELIEVO_OUTCOME_EXHAUSTED);
}

// The exact hits of a frame, kept for the next technique with the same map and scale, which has the
// same rays.
const ReferenceFrame& exactHits(const MeasuredFrame& frame, const HostileMap& hostile,
                                float depthScale) {
    struct Kept {
        std::vector<MeasuredPixel> rays;
        ReferenceFrame hits;
    };
    static std::map<std::pair<std::string_view, float>, Kept> all;
    Kept& kept = all[{hostile.name, depthScale}];
    const auto isSame = [](const MeasuredPixel& a, const MeasuredPixel& b) {
        return a.origin == b.origin && a.direction == b.direction;
    };
    if (!std::ranges::equal(kept.rays, frame.pixels, isSame))
        kept = {frame.pixels,
                traceReference(frame, hostile.map, kEverywhere, static_cast<double>(depthScale))};
    return kept.hits;
}

// How wrong a technique is for the rays of one regime.
struct RegimeErrors {
    std::size_t rays = 0;
    std::size_t wrong = 0;  // off by over a texel along the ray, not converged, or hit against miss
    double worstDepth = 0.0;  // of 1, where both hit
};
using ErrorRow = std::vector<RegimeErrors>;

// Techniques whose hits are solved in their cells: what is wrong is rounding.
bool isSolved(const materials::Technique& technique, const HostileMap& hostile) {
    const bool hasSafeCones = hostile.encoding == textures::ConeEncoding::Ratio;
    return technique.name == "exact" || technique.name == "pyramid" ||
           (technique.name == "cone" && hasSafeCones);
}

void addErrors(const MeasuredFrame& frame, const ReferenceFrame& exact,
               const materials::Technique& technique, const HostileMap& hostile, float depthScale,
               ErrorRow& row) {
    const FloatRounding rounding(hostile.map);
    const auto comparisons =
        compareFrames(frame, exact, hostile.map, static_cast<double>(depthScale));
    ASSERT_EQ(comparisons.size(), frame.pixels.size());
    for (std::size_t k = 0; k < comparisons.size(); ++k) {
        RegimeErrors& errors = row[regimeOfRay(k)];
        ++errors.rays;
        if (reference::summarizeErrors({&comparisons[k], 1}, 1.0 / hostile.map.width()).wrongShare >
            0.0) {
            ++errors.wrong;
            EXPECT_TRUE(!isSolved(technique, hostile) || !comparisons[k].converged ||
                        rounding.explains(frame.pixels[k]))
                << "ray " << k << ", " << hostileRegimes()[regimeOfRay(k)].name << ", t "
                << frame.pixels[k].t;
        }
        if (comparisons[k].found && comparisons[k].exists)
            errors.worstDepth = std::max(
                errors.worstDepth,
                std::abs(static_cast<double>(frame.pixels[k].hit.z) - exact.pixels[k].position.z));
    }
}

// A table of Markdown, a row for each technique that was tested.
void printTable(const std::map<std::string_view, ErrorRow>& rows) {
    fmt::print("| technique |");
    for (const HostileRegime& regime : hostileRegimes())
        fmt::print(" {} |", regime.name);
    fmt::print("\n|---|");
    for (std::size_t k = 0; k < hostileRegimes().size(); ++k)
        fmt::print("---:|");
    fmt::print("\n");
    for (const materials::Technique& technique : materials::techniques())
        if (const auto row = rows.find(technique.name); row != rows.end()) {
            fmt::print("| `{}` |", technique.name);
            for (const RegimeErrors& errors : row->second)
                fmt::print(
                    " {:.2g} ({:.3g}) |", errors.worstDepth,
                    100.0 * static_cast<double>(errors.wrong) / static_cast<double>(errors.rays));
            fmt::print("\n");
        }
}

// Searches whose first look is where the ray begins: one that begins in the solid hits there.
bool looksAtTheStart(std::string_view technique) {
    for (const std::string_view name : {"exact", "pyramid", "cone", "relaxed", "relaxed-secant",
                                        "sphere", "safety-zones", "cylinder"})
        if (technique == name)
            return true;
    return false;
}

// Whether a ray begins in the solid, and not so near the surface that floats cannot tell.
bool beginsInside(const MeasuredPixel& pixel, const textures::DepthMap& map) {
    const auto z = static_cast<double>(pixel.origin.z);
    return z > 0.0 &&
           z > 1e-4 + textures::sampleBilinear(map.depth, static_cast<double>(pixel.origin.x),
                                               static_cast<double>(pixel.origin.y), map.wrap);
}

bool startIsRight(const MeasuredPixel& pixel, std::string_view technique,
                  const textures::DepthMap& map, const glm::vec4& window) {
    const bool mustHit =
        looksAtTheStart(technique) && isWithin(window, pixel.origin) && beginsInside(pixel, map);
    return !mustHit || (pixel.outcome == RELIEVO_OUTCOME_HIT && pixel.t == 0.0f);
}

class Stability : public testing::TestWithParam<const materials::Technique*> {
  protected:
    static void TearDownTestSuite() { printTable(rows_); }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    static inline std::map<std::string_view, ErrorRow> rows_;
};

TEST_P(Stability, HostileRaysAndMaps) {
    HostileFrame hostileFrame(frameSize());
    ErrorRow row(hostileRegimes().size());
    for (const HostileMap& hostile : hostileMaps()) {
        const auto maps = std::make_shared<materials::ReliefMaps>(
            bakeMapsFor(*GetParam(), hostile.map, hostile.encoding), std::string(hostile.name));
        materials::ReliefMaterial material(maps, *GetParam());
        gl::Program program = hostileProgram(material);
        for (const float scale : kDepthScales)
            for (const glm::vec4& window : {kEverywhere, kWindow}) {
                SCOPED_TRACE(fmt::format("{}, depth scale {}, window from {}", hostile.name, scale,
                                         window.x));
                material.depthScale = scale;
                material.window = window;
                const MeasuredFrame frame = hostileFrame.search(material, program);
                for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
                    const MeasuredPixel& pixel = frame.pixels[k];
                    ASSERT_TRUE(pixel.covered && isSound(pixel, mostSteps(material), window))
                        << "ray " << k << ", " << hostileRegimes()[regimeOfRay(k)].name
                        << ", outcome " << pixel.outcome << ", t " << pixel.t << ", steps "
                        << pixel.steps;
                    ASSERT_TRUE(startIsRight(pixel, GetParam()->name, hostile.map, window))
                        << "ray " << k << " begins in the solid and hits at " << pixel.t;
                }
                if (window == kEverywhere)
                    addErrors(frame, exactHits(frame, hostile, scale), *GetParam(), hostile, scale,
                              row);
            }
    }
    rows_[GetParam()->name] = row;
}

INSTANTIATE_TEST_SUITE_P(Techniques, Stability, testing::ValuesIn(everyTechnique()),
                         nameOfTest<materials::Technique>);

// What the test above looks for, it would find.
TEST(Soundness, SeesWhatIsWrong) {
    MeasuredPixel sound;
    sound.steps = 5;
    ASSERT_TRUE(isSound(sound, 5, kWindow));
    const auto broken = [&](const auto& breakIt) {
        MeasuredPixel pixel = sound;
        breakIt(pixel);
        return !isSound(pixel, 5, kWindow);
    };
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.hit.x = std::nanf(""); }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.t = HUGE_VALF; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.normal.z = std::nanf(""); }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.steps = 6; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.t = -1.0f; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.hit.z = 1.1f; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.hit.x = 2.3f; }));
    EXPECT_TRUE(broken([](MeasuredPixel& pixel) { pixel.outcome = 7; }));
}

}  // namespace
}  // namespace relievo::viewer
