#include "surfaces/surface_mesh.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "frame_checks.h"

namespace relievo::surfaces {
namespace {

TEST(SurfaceMesh, TangentFramesAgreeWithPositionsAndUv) {
    EXPECT_TRUE(framesAgree(makeQuad({1, 1}, 1.0f)));
    EXPECT_TRUE(framesAgree(makeQuad({3, 2}, 0.5f)));
    EXPECT_TRUE(framesAgree(makeBox({1, 1})));
    EXPECT_TRUE(framesAgree(makeBox({2, 5})));
}

TEST(SurfaceMesh, PlacedMeshesKeepTheirFrames) {
    const glm::mat4 turned = glm::rotate(glm::mat4(1), 1.1f, glm::vec3(1, 2, 3));
    EXPECT_TRUE(framesAgree(placed(makeBox({2, 5}), glm::translate(turned, {3, 1, 2}))));
    EXPECT_TRUE(framesAgree(placed(makeBox({2, 5}), glm::scale(turned, {0.5f, 2.0f, 1.0f}))));
    EXPECT_TRUE(framesAgree(placed(makeBox({2, 5}), glm::scale(turned, {1, 1, -1}))));
    // Skewed: the faces do not stay rectangles.
    glm::mat4 skewed(1);
    skewed[1][0] = 0.5f;
    skewed[2][1] = -0.25f;
    EXPECT_TRUE(framesAgree(placed(makeBox({2, 5}), skewed)));
    const SurfaceMesh moved = placed(makeQuad({1, 1}, 1), glm::translate(glm::mat4(1), {3, 1, 2}));
    EXPECT_EQ(moved.vertices[0].position, glm::vec3(2.5f, 1.5f, 2));
    EXPECT_EQ(moved.vertices[0].normal, glm::vec3(0, 0, 1));
}

TEST(SurfaceMesh, TheCheckCatchesAFlippedBitangent) {
    SurfaceMesh mesh = makeBox({1, 1});
    mesh.vertices[5].bitangent *= -1.0f;
    mesh.vertices[4].bitangent *= -1.0f;
    EXPECT_FALSE(framesAgree(mesh));
}

TEST(SurfaceMesh, QuadKeepsTexelsSquare) {
    // A map half as high as wide, 3 × 2 times: a tile is 1/3 wide, so 1/6 high.
    const SurfaceMesh mesh = makeQuad({3, 2}, 0.5f);
    EXPECT_NEAR(glm::length(mesh.vertices[0].tangent), 1.0f / 3, 1e-6f);
    EXPECT_NEAR(glm::length(mesh.vertices[0].bitangent), 1.0f / 6, 1e-6f);
    EXPECT_EQ(mesh.windowMaximum, glm::vec2(3, 2));
}

TEST(SurfaceMesh, TopLeftOfThePictureIsAtTheFarLeft) {
    const SurfaceMesh mesh = makeQuad({1, 1}, 1.0f);
    EXPECT_EQ(mesh.vertices[0].uv, glm::vec2(0, 0));
    EXPECT_EQ(mesh.vertices[0].position, glm::vec3(-0.5f, 0.5f, 0));
}

TEST(SurfaceMesh, BoxFacesPointOutwards) {
    for (const SurfaceVertex& vertex : makeBox({1, 1}).vertices)
        EXPECT_NEAR(glm::dot(vertex.position, vertex.normal), 0.5f, 1e-6f);
}

}  // namespace
}  // namespace relievo::surfaces
