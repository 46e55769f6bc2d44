// Frames of several objects: depths decide between them, in any order of drawing.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "relief_scene.h"
#include "viewer/frame_renderer.h"

namespace relievo::viewer {
namespace {

constexpr int kSize = 64;

class SeveralObjects : public testing::Test {
  protected:
    SeveralObjects()
        : maps_(std::make_shared<materials::ReliefMaps>(
              bakeMaps(textures::generateSampleRelief("wave", 64, 64)), "test")),
          material_(maps_, materials::findTechnique("exact")),
          floor_(surfaces::makeQuad({1, 1}, 1.0f)),
          target_(makeColorTarget(kSize, kSize)) {
        material_.depthScale = 0.2f;
        material_.window = {0, 0, 1, 1};
        view_.camera = perspectiveCamera(OrbitCamera{}, 1.0f);
    }

    SceneObject relief() const {
        SceneObject object;
        object.surface = &floor_;
        object.material = &material_;
        return object;
    }
    // As large as the floor, whose relief goes down to z = −0.2.
    static SurfaceBuffers planeAt(float z) {
        return SurfaceBuffers(placed(surfaces::makeQuad({1, 1}, 1.0f),
                                     glm::translate(glm::mat4(1), glm::vec3(0, 0, z))));
    }
    std::vector<float> picture(const std::vector<SceneObject>& objects) {
        frames_.draw(objects, view_, target_);
        return target_.read(0);
    }
    // The share of pixels in which two pictures differ.
    static double difference(const std::vector<float>& a, const std::vector<float>& b) {
        std::size_t differing = 0;
        for (std::size_t k = 0; k < a.size(); k += 4)
            differing += !std::equal(&a[k], &a[k] + 4, &b[k]);
        return static_cast<double>(differing) / (kSize * kSize);
    }

    std::unique_ptr<gl::Context> context_ = makeTestContext();
    std::shared_ptr<materials::ReliefMaps> maps_;
    materials::ReliefMaterial material_;
    SurfaceBuffers floor_;
    FrameRenderer frames_;
    FrameView view_;
    gl::Framebuffer target_;
};

TEST_F(SeveralObjects, TheNearerOneIsSeenWhateverTheOrder) {
    const SurfaceBuffers surface = planeAt(-0.1f);
    SceneObject mesh;
    mesh.surface = &surface;
    const std::vector<float> both = picture({relief(), mesh});
    EXPECT_EQ(both, picture({mesh, relief()}));
    // Each hides a part of the other.
    EXPECT_GT(difference(both, picture({relief()})), 0.1);
    EXPECT_GT(difference(both, picture({mesh})), 0.1);
}

}  // namespace
}  // namespace relievo::viewer
