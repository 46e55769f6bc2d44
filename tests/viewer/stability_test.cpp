// No technique may produce a NaN, an infinity, an unbounded search or a hit outside the relief, for
// any ray, scale or map.
#include <gtest/gtest.h>

#include <cmath>

#include "materials/technique_registry.h"
#include "relief_scene.h"
#include "shaders/relievo/constants.h"
#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

textures::DepthMap noiseMap(int width, int height, textures::WrapMode wrap) {
    textures::DepthMap map{textures::Plane(width, height), wrap};
    std::uint32_t state = 12345;
    for (float& depth : map.depth.texels) {
        state = state * 1664525u + 1013904223u;
        depth = static_cast<float>(state >> 8) / 16777216.0f;
    }
    return map;
}

textures::DepthMap binaryMap() {
    textures::DepthMap map = noiseMap(16, 16, textures::WrapMode::Repeat);
    for (float& depth : map.depth.texels)
        depth = depth > 0.5f ? 1.0f : 0.0f;
    return map;
}

class Stability : public testing::Test {
  protected:
    // No search takes more steps than its parameters, the numbers of steps of each kind, allow; and
    // one step needs no parameter.
    static double mostSteps(const materials::ReliefMaterial& material) {
        double steps = 1.0;
        for (const materials::TechniqueParameter& parameter : material.technique().parameters)
            if (parameter.isInteger)
                steps += material.parameter(parameter.name);
        return steps;
    }

    static void expectSound(const MeasuredFrame& frame, double mostSteps) {
        for (const MeasuredPixel& pixel : frame.pixels) {
            if (!pixel.covered)
                continue;
            ASSERT_TRUE(isFinite(pixel.hit) && std::isfinite(pixel.t) && isFinite(pixel.normal));
            ASSERT_LE(pixel.steps, mostSteps);
            ASSERT_GE(pixel.t, 0.0f);
            if (pixel.outcome == RELIEVO_OUTCOME_HIT) {
                ASSERT_GE(pixel.hit.z, 0.0f);
                ASSERT_LE(pixel.hit.z, 1.001f);
            }
        }
    }

    static void probe(const textures::DepthMap& map, textures::ConeEncoding encoding) {
        for (const materials::Technique& technique : materials::techniques()) {
            RayScene scene(bakeMapsFor(technique, map, encoding), 0.0f, 90.0f);
            materials::ReliefMaterial material = scene.renderer.makeMaterial(technique);
            for (const float scale : {0.0f, 1e-6f, 1.0f, 1e3f})
                for (const float elevation : {90.0f, 45.0f, 1.0f, 0.01f, 0.0f})
                    for (const float azimuth : {0.0f, 90.0f, 37.0f}) {
                        SCOPED_TRACE(testing::Message()
                                     << technique.name << " scale " << scale << " elevation "
                                     << elevation << " azimuth " << azimuth);
                        scene.look(azimuth, elevation, scale);
                        expectSound(scene.renderer.measure(material, scene.view, 8, 8),
                                    mostSteps(material));
                        if (testing::Test::HasFatalFailure())
                            return;
                    }
        }
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
};

TEST_F(Stability, ConstantMaps) {
    for (const float depth : {0.0f, 0.5f, 1.0f})
        probe({textures::Plane(8, 8, depth), textures::WrapMode::Repeat},
              textures::ConeEncoding::Radius);
}

TEST_F(Stability, NarrowMaps) {
    probe(noiseMap(1, 1, textures::WrapMode::Repeat), textures::ConeEncoding::Ratio);
    probe(noiseMap(1, 13, textures::WrapMode::Mirror), textures::ConeEncoding::Ratio);
    probe(noiseMap(64, 1, textures::WrapMode::Clamp), textures::ConeEncoding::Radius);
}

TEST_F(Stability, NoiseAndBinaryMaps) {
    probe(noiseMap(17, 11, textures::WrapMode::Mirror), textures::ConeEncoding::Radius);
    probe(binaryMap(), textures::ConeEncoding::Ratio);
    probe(binaryMap(), textures::ConeEncoding::Radius);
}

}  // namespace
}  // namespace relievo::viewer
