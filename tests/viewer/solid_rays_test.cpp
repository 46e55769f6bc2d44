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
    const int side = size == nullptr ? 48 : 3 * std::stoi(size);
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

materials::SolidMaterial materialOf(SolidStage& stage, const SolidCase& solid) {
    materials::SolidMaterial material(stage.shapes, solid.compound,
                                      materials::findSolidTechnique("solid"));
    material.low = solid.low;
    material.high = solid.high;
    material.hasFloor = false;
    return material;
}

class SolidRays : public testing::Test {
  protected:
    static void SetUpTestSuite() { stage_ = std::make_unique<SolidStage>(); }
    static void TearDownTestSuite() {
        programs_.clear();
        stage_.reset();
    }

    // Of solids with parts of the same kinds.
    static gl::Program& programOf(const materials::SolidMaterial& material) {
        std::string key;
        for (const shaders::Define& define : material.defines())
            key += define.name + define.value;
        const auto found = programs_.find(key);
        if (found != programs_.end())
            return found->second;
        return programs_.emplace(key, solidRayProgram(material)).first->second;
    }

    static inline std::unique_ptr<SolidStage> stage_;
    static inline std::map<std::string, gl::Program> programs_;
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

}  // namespace
}  // namespace relievo::viewer
