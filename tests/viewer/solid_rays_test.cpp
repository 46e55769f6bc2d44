// Rays that no camera would think of, against the double-precision tracer: grazing and level ones,
// along axes and borders of texels, from inside and from far away, of directions of any length.
// None may give a NaN, a search without bounds or a wrong hit; and searches whose steps are too
// long are found out. The environment variable RELIEVO_FRAME_SIZE makes for more rays.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include "hostile_solid_rays.h"
#include "materials/solid_registry.h"
#include "shaders/relievo/constants.h"
#include "solid_rounding.h"
#include "solid_samples.h"
#include "solid_scene.h"

namespace relievo::viewer {
namespace {

int rayCount() {
    const char* const size = std::getenv("RELIEVO_FRAME_SIZE");
    const int side = size == nullptr ? 36 : 3 * std::stoi(size);
    return side * side;
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isSound(const MeasuredPixel& pixel, double mostSteps) {
    const bool isKnown = pixel.outcome == RELIEVO_OUTCOME_HIT ||
                         pixel.outcome == RELIEVO_OUTCOME_MISS ||
                         pixel.outcome == RELIEVO_OUTCOME_EXHAUSTED;
    return isKnown && isFinite(pixel.hit) && std::isfinite(pixel.t) && isFinite(pixel.normal) &&
           pixel.t >= 0.0f && pixel.steps <= mostSteps;
}

// Near what is seen of a surface without an end.
SolidCase around(SolidCase solid) {
    for (int axis = 0; axis < 2; ++axis)
        if (!std::isfinite(solid.low[axis])) {
            solid.low[axis] = solid.compound.parts[0].windowMinimum[axis] = -2.0;
            solid.high[axis] = solid.compound.parts[0].windowMaximum[axis] = 3.0;
        }
    return solid;
}

materials::SolidMaterial materialOf(SolidTestStage& stage, const SolidCase& solid) {
    materials::SolidMaterial material(stage.shapes, solid.compound,
                                      materials::findSolidTechnique("solid"));
    material.low = solid.low;
    material.high = solid.high;
    material.boxFromWhole = glm::dmat4(1.0);
    return material;
}

// Of solids with parts of the same kinds.
class Programs {
  public:
    template <typename Make>
    gl::Program& of(const materials::SolidMaterial& material, const Make& make) {
        std::string key;
        for (const shaders::Define& define : material.defines())
            key += define.name + define.value;
        const auto found = programs_.find(key);
        return found != programs_.end() ? found->second
                                        : programs_.emplace(key, make()).first->second;
    }

    void clear() { programs_.clear(); }

  private:
    std::map<std::string, gl::Program> programs_;
};

class SolidRays : public testing::Test {
  protected:
    static void SetUpTestSuite() { stage_ = std::make_unique<SolidTestStage>(); }
    static void TearDownTestSuite() {
        programs_.clear();
        stage_.reset();
    }

    static gl::Program& programOf(const materials::SolidMaterial& material) {
        return programs_.of(material, [&] { return solidRayProgram(material); });
    }

    static inline std::unique_ptr<SolidTestStage> stage_;
    static inline Programs programs_;
};

struct RegimeTally {
    int rays = 0;
    int wrong = 0;
    int exhausted = 0;
};

std::string describe(const MeasuredPixel& pixel, const SolidRounding& rounding) {
    const auto hit = rounding.exact().firstHit(rayOf(pixel));
    return fmt::format(
        "outcome {} t {:.9g}, exact {:.9g}, steps {}, from ({:.9g}, {:.9g}, {:.9g}) "
        "along ({:.9g}, {:.9g}, {:.9g}) to {:.9g}",
        pixel.outcome, pixel.t, hit ? hit->t : -1.0, pixel.steps, pixel.origin.x, pixel.origin.y,
        pixel.origin.z, pixel.direction.x, pixel.direction.y, pixel.direction.z, pixel.end);
}

TEST_F(SolidRays, HitFirstWhereTheSolidIs) {
    std::map<std::string_view, RegimeTally> tallies;
    for (const auto& cases : {extrusionCases(), revolutionCases(), compoundCases()})
        for (const SolidCase& endless : cases) {
            const SolidCase solid = around(endless);
            const materials::SolidMaterial material = materialOf(*stage_, solid);
            const SolidRounding rounding(solid.compound);
            const std::vector<HostileSolidRay> rays =
                hostileSolidRays(solid.low, solid.high, rayCount());
            const std::vector<MeasuredPixel> pixels =
                searchRays(material, programOf(material), rays);
            int shown = 0;
            for (std::size_t k = 0; k < rays.size(); ++k) {
                const MeasuredPixel& pixel = pixels[k];
                RegimeTally& tally = tallies[rays[k].regime];
                ++tally.rays;
                EXPECT_TRUE(isSound(pixel, material.parameter("solid-steps")))
                    << solid.name << ", " << rays[k].regime << ": " << describe(pixel, rounding);
                if (pixel.end < 0.0f)
                    continue;
                const bool isExhausted = pixel.outcome == RELIEVO_OUTCOME_EXHAUSTED;
                const bool isRight = isExhausted || rounding.judge(pixel).isRight;
                tally.exhausted += isExhausted ? 1 : 0;
                tally.wrong += isRight ? 0 : 1;
                if ((isExhausted || !isRight) && ++shown <= 3)
                    ADD_FAILURE() << solid.name << ", " << rays[k].regime << ": "
                                  << describe(pixel, rounding);
            }
        }
    fmt::print("| rays | number | wrong | exhausted |\n|---|---:|---:|---:|\n");
    for (const auto& [regime, tally] : tallies) {
        fmt::print("| {} | {} | {} | {} |\n", regime, tally.rays, tally.wrong, tally.exhausted);
        EXPECT_EQ(tally.wrong, 0) << regime;
    }
}

// Solids that there is nothing, or only a point, or all of; and numbers without sense.
std::vector<SolidCase> absurdCases() {
    std::vector<SolidCase> cases;
    const auto add = [&](const char* name, float distance, solids::SolidKind kind, double size) {
        auto shape = std::make_shared<textures::ShapeMap>();
        for (textures::Plane* plane : {&shape->distance, &shape->gradientX, &shape->gradientY})
            *plane = textures::Plane(7, 3, plane == &shape->distance ? distance : 0.0f);
        solids::SolidPart part;
        part.solid.shape = std::move(shape);
        part.solid.kind = kind;
        part.solid.profile = solids::makeProfile(0.0, size, 0.5);
        part.solid.extension = size;
        SolidCase result{name, {{part}}, true};
        cases.push_back(result);
    };
    for (const solids::SolidKind kind :
         {solids::SolidKind::Extrusion, solids::SolidKind::Revolution}) {
        add("empty", 4.0f, kind, 0.0);
        add("full", -4.0f, kind, 0.0);
        add("on the surface everywhere", 0.0f, kind, 0.0);
        add("huge", 1e30f, kind, 1e30);
        add("tiny", 1e-38f, kind, -1e-30);
    }
    for (SolidCase& solid : std::vector<SolidCase>(cases)) {
        solid.name += ", in a window without a volume";
        solid.high = solid.compound.parts[0].windowMaximum = glm::dvec3(0.0);
        cases.push_back(solid);
    }
    for (const auto& sound : {extrusionCases(), revolutionCases(), compoundCases()})
        for (const SolidCase& solid : sound)
            cases.push_back(around(solid));
    return cases;
}

// Of a number that is none nothing is asked but an end.
TEST_F(SolidRays, EndWhateverTheyAre) {
    for (const SolidCase& solid : absurdCases()) {
        materials::SolidMaterial material = materialOf(*stage_, solid);
        material.setParameter("solid-steps", 500);
        gl::Program& program = programOf(material);
        const std::vector<HostileSolidRay> rays = absurdSolidRays();
        const std::vector<MeasuredPixel> pixels = searchRays(material, program, rays);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            const MeasuredPixel& pixel = pixels[k];
            ASSERT_LE(pixel.steps, material.parameter("solid-steps")) << solid.name;
            // Where squares of numbers are none any more, neither are normals.
            const bool isNumber = isFinite(rays[k].origin) && isFinite(rays[k].direction) &&
                                  glm::length(rays[k].origin) < 1e6f &&
                                  glm::length(rays[k].direction) < 1e6f;
            EXPECT_TRUE(!isNumber || isSound(pixel, material.parameter("solid-steps")))
                << solid.name << ": t " << pixel.t << ", outcome " << pixel.outcome << ", ray "
                << k;
        }
        for (const MeasuredPixel& pixel :
             searchRays(material, program, hostileSolidRays(solid.low, solid.high, 1000)))
            EXPECT_TRUE(isSound(pixel, material.parameter("solid-steps"))) << solid.name;
    }
}

struct Variant {
    const char* name;
    solids::SolidKind kind;
    const char* ours;
    const char* other;
};

constexpr char kLanding[] =
    "if (!(t > leap.clear) || kSolidOverlap * t - back <= leap.clear) return true;";
constexpr char kIsland[] = "if (clear < leap.island.x) return clear;";

constexpr Variant kWrongVariants[] = {
    {"steps half as far again as is safe", solids::SolidKind::Extrusion,
     "const float kSolidShort = 1.0 - 1e-5;", "const float kSolidShort = 1.5;"},
    {"steps as far as true distances would allow", solids::SolidKind::Extrusion,
     "float straight = gap / max(1.41421356 * speed + closing, 1e-30);",
     "return gap / max(speed + closing, 1e-30); float straight;"},
    {"chamfers that do not come nearer", solids::SolidKind::Extrusion,
     "float closing = solidPieces[index].chords[way] * abs(dz);", "float closing = 0.0;"},
    {"chamfers that retreat as fast again", solids::SolidKind::Extrusion,
     "float closing = solidPieces[index].chords[way] * abs(dz);",
     "float closing = solidPieces[index].chords[way] * abs(dz); closing *= closing < 0.0 ? 2.0 : "
     "1.0;"},
    {"steps by distances around corners", solids::SolidKind::Extrusion,
     "distances - solidCreaseDepth(part) * share", "distances"},
    {"spheres half as large again as is safe", solids::SolidKind::Revolution,
     "const float kSolidShort = 1.0 - 1e-5;", "const float kSolidShort = 1.5;"},
    {"steps over the borders of replicas", solids::SolidKind::Revolution, "if (clear < tileExit) {",
     "if (clear < path.leave) {"},
    {"straight lines for parabolas", solids::SolidKind::Revolution,
     "return max(2.0 * value / max(parabola, 1e-30), value / max(slopes.z, 1e-30));",
     "return value / max(-slopes.x, 1e-6);"},
    {"leaps that nothing makes good", solids::SolidKind::Extrusion, kLanding, "return true;"},
    {"leaps in sections that nothing makes good", solids::SolidKind::Revolution, kLanding,
     "return true;"},
    {"leaps on to what is free behind a gap", solids::SolidKind::Extrusion, kIsland,
     "if (leap.island.x == kReliefBoundless) return clear;"},
};

gl::Program variantProgram(const materials::SolidMaterial& material, const Variant& variant) {
    return solidRayProgram(material, [&](std::string text) {
        const std::size_t place = text.find(variant.ours);
        EXPECT_NE(place, std::string::npos) << variant.name;
        if (place != std::string::npos)
            text.replace(place, std::string(variant.ours).size(), variant.other);
        return text;
    });
}

TEST_F(SolidRays, FindOutWrongSearches) {
    for (const Variant& variant : kWrongVariants) {
        Programs programs;
        int wrong = 0;
        const bool isRevolution = variant.kind == solids::SolidKind::Revolution;
        for (const SolidCase& endless : isRevolution ? revolutionCases() : extrusionCases()) {
            const SolidCase solid = around(endless);
            const materials::SolidMaterial material = materialOf(*stage_, solid);
            gl::Program& program =
                programs.of(material, [&] { return variantProgram(material, variant); });
            const SolidRounding rounding(solid.compound);
            for (const MeasuredPixel& pixel :
                 searchRays(material, program, hostileSolidRays(solid.low, solid.high, 900)))
                wrong += pixel.end >= 0.0f && !rounding.judge(pixel).isRight ? 1 : 0;
        }
        fmt::print("{}: {} wrong\n", variant.name, wrong);
        EXPECT_GT(wrong, 9) << variant.name;
    }
}

double meanFetches(const std::vector<MeasuredPixel>& pixels) {
    double sum = 0.0;
    for (const MeasuredPixel& pixel : pixels)
        sum += pixel.fetches;
    return sum / static_cast<double>(pixels.size());
}

TEST_F(SolidRays, TakeFewerLookupsForLeaps) {
    for (const solids::SolidKind kind :
         {solids::SolidKind::Extrusion, solids::SolidKind::Revolution}) {
        const Variant without{"no leaps", kind,
                              "bool isRefused = leap.wasLost || !(outlook.radius > kSolidNearest);",
                              "bool isRefused = true;"};
        Programs programs;
        double leaping = 0.0;
        double walking = 0.0;
        const bool isRevolution = kind == solids::SolidKind::Revolution;
        for (const SolidCase& endless : isRevolution ? revolutionCases() : extrusionCases()) {
            const SolidCase solid = around(endless);
            const materials::SolidMaterial material = materialOf(*stage_, solid);
            gl::Program& program =
                programs.of(material, [&] { return variantProgram(material, without); });
            const std::vector<HostileSolidRay> rays = hostileSolidRays(solid.low, solid.high, 900);
            const double other = meanFetches(searchRays(material, program, rays));
            const double ours = meanFetches(searchRays(material, programOf(material), rays));
            // In noise of single texels no guess is right.
            EXPECT_LT(ours, 1.2 * other) << solid.name;
            leaping += ours;
            walking += other;
        }
        fmt::print("{} lookups with leaps, {} without\n", leaping, walking);
        EXPECT_LT(leaping, 0.95 * walking);
    }
}

}  // namespace
}  // namespace relievo::viewer
