// Frames from positions and uv: exact where the mapping is affine, of second order on a torus,
// defined where uv or triangles are degenerate.
#include "surfaces/tangent_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "frame_checks.h"
#include "surfaces/parametric_meshes.h"

namespace relievo::surfaces {
namespace {

TriangleMesh trianglesOf(const SurfaceMesh& mesh) {
    TriangleMesh triangles;
    for (const SurfaceVertex& vertex : mesh.vertices) {
        triangles.positions.push_back(vertex.position);
        triangles.uv.push_back(vertex.uv);
        triangles.normals.push_back(vertex.normal);
    }
    triangles.indices = mesh.indices;
    return triangles;
}

// A square of two triangles, whose uv are those of its corners under (u,v) = (a·x + b·y, c·x +
// d·y).
TriangleMesh squareWithUv(float a, float b, float c, float d) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const glm::vec3& p : mesh.positions)
        mesh.uv.push_back({a * p.x + b * p.y, c * p.x + d * p.y});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

// Two triangles on either side of x = 0, with u = |x|: what a symmetrical model has.
TriangleMesh mirroredAtTheMiddle() {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
    for (const glm::vec3& p : mesh.positions)
        mesh.uv.push_back({std::abs(p.x), -p.y});
    mesh.indices = {0, 1, 2, 1, 0, 3};
    return mesh;
}

bool isFinite(const SurfaceMesh& mesh) {
    return std::ranges::all_of(mesh.vertices, [](const SurfaceVertex& vertex) {
        const float sum =
            glm::dot(vertex.position, vertex.position) + glm::dot(vertex.tangent, vertex.tangent) +
            glm::dot(vertex.bitangent, vertex.bitangent) + glm::dot(vertex.uv, vertex.uv);
        return std::isfinite(sum) && std::abs(glm::length(vertex.normal) - 1.0f) < 1e-5f;
    });
}

TEST(TangentFrames, AreThoseOfQuadAndBox) {
    for (const SurfaceMesh& mesh : {makeQuad({3, 2}, 0.5f), makeBox({2, 5})}) {
        const SurfaceMesh found = withTangentFrames(trianglesOf(mesh));
        EXPECT_EQ(found.vertices.size(), mesh.vertices.size());
        EXPECT_TRUE(framesAgree(found));
    }
}

TEST(TangentFrames, AreSkewedOrMirroredAsTheUvAre) {
    EXPECT_TRUE(framesAgree(withTangentFrames(squareWithUv(1, 0, 0, -1))));
    EXPECT_TRUE(framesAgree(withTangentFrames(squareWithUv(2, 1.5f, 0.25f, -1))));
    EXPECT_TRUE(framesAgree(withTangentFrames(squareWithUv(-1, 0, 0, -1))));
    EXPECT_TRUE(framesAgree(withTangentFrames(squareWithUv(0, 3, 1, 1))));
    const SurfaceMesh skewed = withTangentFrames(squareWithUv(1, 1, 0, -1));
    EXPECT_NEAR(glm::dot(skewed.vertices[0].tangent, skewed.vertices[0].bitangent), 1.0f, 1e-6f);
}

TEST(TangentFrames, VerticesSplitWhereMirroredUvMeet) {
    const TriangleMesh mesh = mirroredAtTheMiddle();
    const SurfaceMesh found = withTangentFrames(mesh);
    EXPECT_EQ(found.vertices.size(), 6u);
    EXPECT_TRUE(framesAgree(found));
    // Averaged over both sides, u would lead nowhere.
    SurfaceMesh shared = found;
    for (SurfaceVertex& vertex : shared.vertices)
        if (vertex.position.x == 0.0f)
            vertex.tangent = glm::vec3(0.0f);
    EXPECT_FALSE(framesAgree(shared));
}

// The largest deviation from the exact frames of a torus, as a share of the longest tangent.
double torusDeviation(Divisions divisions) {
    const SurfaceMesh exact = makeTorus({6, 2}, divisions);
    TriangleMesh triangles = trianglesOf(exact);
    triangles.normals.clear();
    const SurfaceMesh found = withTangentFrames(triangles);
    EXPECT_EQ(found.vertices.size(), exact.vertices.size());
    double most = 0.0;
    for (std::size_t k = 0; k < found.vertices.size(); ++k) {
        // At the seams the average has one side only.
        const glm::vec2 uv = exact.vertices[k].uv;
        if (uv.x == 0.0f || uv.x == 6.0f || uv.y == 0.0f || uv.y == 2.0f)
            continue;
        const auto distance = [&](auto member) {
            return double{glm::distance(found.vertices[k].*member, exact.vertices[k].*member)};
        };
        most = std::max({most, distance(&SurfaceVertex::tangent),
                         distance(&SurfaceVertex::bitangent), distance(&SurfaceVertex::normal)});
    }
    return most / extentOf(exact).widestTile;
}

TEST(TangentFrames, ConvergeToThoseOfATorus) {
    const double coarse = torusDeviation({48, 16});
    const double fine = torusDeviation({96, 32});
    EXPECT_LT(coarse, 0.1);
    EXPECT_LT(fine, coarse / 3.5);
}

TEST(TangentFrames, NormalsAreSmoothAcrossSeamsOfUv) {
    TriangleMesh triangles = trianglesOf(makeTorus({6, 2}));
    triangles.normals.clear();
    const SurfaceMesh found = withTangentFrames(triangles);
    const SurfaceMesh exact = makeTorus({6, 2});
    for (std::size_t k = 0; k < found.vertices.size(); ++k)
        EXPECT_GT(glm::dot(found.vertices[k].normal, exact.vertices[k].normal), 0.999f);
}

TEST(TangentFrames, NormalsOfTheFileStay) {
    TriangleMesh mesh = squareWithUv(1, 0, 0, -1);
    const glm::vec3 leaning = glm::normalize(glm::vec3(0.6f, 0, 0.8f));
    mesh.normals = {2.0f * leaning, leaning, leaning, {0, 0, 0}};
    const SurfaceMesh found = withTangentFrames(mesh);
    EXPECT_LT(glm::distance(found.vertices[0].normal, leaning), 1e-6f);
    EXPECT_EQ(found.vertices[3].normal, glm::vec3(0, 0, 1));
    for (const SurfaceVertex& vertex : found.vertices) {
        EXPECT_NEAR(glm::dot(vertex.normal, vertex.tangent), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::dot(vertex.normal, vertex.bitangent), 0.0f, 1e-6f);
    }
}

TEST(TangentFrames, BothSidesOfASheetHaveTheirOwnNormals) {
    TriangleMesh mesh = squareWithUv(1, 0, 0, -1);
    const TriangleMesh front = mesh;
    mesh.positions.insert(mesh.positions.end(), front.positions.begin(), front.positions.end());
    mesh.uv.insert(mesh.uv.end(), front.uv.begin(), front.uv.end());
    for (const std::uint32_t corner : {0u, 2u, 1u, 0u, 3u, 2u})
        mesh.indices.push_back(4 + corner);
    const SurfaceMesh found = withTangentFrames(mesh);
    EXPECT_EQ(found.vertices.size(), 8u);
    EXPECT_TRUE(framesAgree(found));
}

TEST(TangentFrames, TrianglesWithoutAreaAreLeftOut) {
    TriangleMesh mesh = squareWithUv(1, 0, 0, -1);
    mesh.positions.push_back({0.5f, 0.5f, 0});
    mesh.uv.push_back({7, 7});
    for (const std::uint32_t corner : {0u, 2u, 4u, 1u, 1u, 3u})
        mesh.indices.push_back(corner);
    const SurfaceMesh found = withTangentFrames(mesh);
    EXPECT_EQ(found.indices.size(), 6u);
    EXPECT_EQ(found.vertices.size(), 4u);
    EXPECT_TRUE(framesAgree(found));
    mesh.indices = {0, 2, 4};
    EXPECT_TRUE(withTangentFrames(mesh).vertices.empty());
}

TEST(TangentFrames, WhereUvSayNothingTilesAreTiny) {
    TriangleMesh missing = squareWithUv(1, 0, 0, -1);
    missing.uv.clear();
    TriangleMesh huge = squareWithUv(1, 0, 0, -1);
    for (glm::vec2& uv : huge.uv)
        uv *= 1e-30f;
    for (const TriangleMesh& mesh :
         {missing, squareWithUv(0, 0, 0, 0), squareWithUv(1, 1, 2, 2), huge}) {
        const SurfaceMesh found = withTangentFrames(mesh);
        EXPECT_EQ(found.indices.size(), 6u);
        EXPECT_TRUE(isFinite(found));
        for (const SurfaceVertex& vertex : found.vertices) {
            EXPECT_FLOAT_EQ(glm::length(vertex.tangent), kTinyTile);
            const glm::vec3 across = glm::cross(vertex.bitangent, vertex.tangent);
            EXPECT_GT(glm::dot(across, vertex.normal), 0.99f * kTinyTile * kTinyTile);
        }
    }
}

// A triangle whose uv are one point, between others: theirs is the frame.
TEST(TangentFrames, TrianglesWithoutUvTakeTheFramesOfTheirNeighbours) {
    TriangleMesh mesh = squareWithUv(1, 0, 0, -1);
    mesh.positions.push_back({0.5f, 2, 0});
    mesh.uv.push_back(0.5f * (mesh.uv[2] + mesh.uv[3]));
    mesh.indices.insert(mesh.indices.end(), {3, 2, 4});
    const SurfaceMesh found = withTangentFrames(mesh);
    ASSERT_EQ(found.vertices.size(), 5u);
    EXPECT_LT(glm::distance(found.vertices[2].tangent, glm::vec3(1, 0, 0)), 1e-6f);
    EXPECT_TRUE(isFinite(found));
}

}  // namespace
}  // namespace relievo::surfaces
