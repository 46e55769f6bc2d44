// Spheres and tori against their formulas: positions, derivatives by finite differences, winding.
#include "surfaces/parametric_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <tuple>

namespace relievo::surfaces {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr Tiles kTiles{3, 2};

using Formula = std::function<glm::dvec3(glm::dvec2 uv)>;

// As the header has them, in tiles.
glm::dvec3 spherePosition(glm::dvec2 uv) {
    const double a = kTurn * uv.x / kTiles.x;
    const double b = std::numbers::pi * uv.y / kTiles.y;
    return 0.5 * glm::dvec3(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
}

glm::dvec3 torusPosition(glm::dvec2 uv) {
    const double a = kTurn * uv.x / kTiles.x;
    const double b = kTurn * uv.y / kTiles.y;  // from the inside over the top
    const double ring = kTorusRadius - kTubeRadius * std::cos(b);
    return {ring * std::cos(a), ring * std::sin(a), kTubeRadius * std::sin(b)};
}

// The largest distances of the vertices and their frames from a formula and its differences.
struct Deviation {
    double position = 0.0;
    double tangent = 0.0;
    double bitangent = 0.0;
    double normal = 0.0;
};

Deviation deviationFrom(const Formula& formula, const SurfaceMesh& mesh) {
    constexpr double kStep = 1e-5;
    Deviation most;
    const auto include = [](double& largest, const glm::vec3& found, const glm::dvec3& expected) {
        largest = std::max(largest, glm::length(glm::dvec3(found) - expected));
    };
    for (const SurfaceVertex& vertex : mesh.vertices) {
        const glm::dvec2 uv(vertex.uv);
        const auto difference = [&](glm::dvec2 step) {
            return (formula(uv + step) - formula(uv - step)) / (2.0 * kStep);
        };
        const glm::dvec3 alongU = difference({kStep, 0});
        const glm::dvec3 alongV = difference({0, kStep});
        include(most.position, vertex.position, formula(uv));
        include(most.tangent, vertex.tangent, alongU);
        include(most.bitangent, vertex.bitangent, alongV);
        const glm::dvec3 normal = glm::cross(alongV, alongU);
        if (glm::length(normal) > 1e-4)  // not at a pole
            include(most.normal, vertex.normal, glm::normalize(normal));
    }
    return most;
}

TEST(ParametricMeshes, FramesAreTheDerivativesOfTheFormulas) {
    for (const auto& [formula, mesh] :
         {std::pair{Formula(spherePosition), makeSphere(kTiles, {12, 7})},
          std::pair{Formula(torusPosition), makeTorus(kTiles, {11, 5})}}) {
        const Deviation most = deviationFrom(formula, mesh);
        EXPECT_LT(most.position, 1e-6);
        EXPECT_LT(most.tangent, 1e-6);
        EXPECT_LT(most.bitangent, 1e-6);
        EXPECT_LT(most.normal, 1e-6);
    }
}

TEST(ParametricMeshes, TheCheckSeesFramesForOtherTiles) {
    const Deviation most = deviationFrom(torusPosition, makeTorus({3, 3}));
    EXPECT_GT(most.bitangent, 0.05);
}

// Each edge is gone along once in each direction, and the seams have no cracks.
bool isClosed(const SurfaceMesh& mesh) {
    using Point = std::tuple<float, float, float>;
    std::map<std::pair<Point, Point>, int> edges;
    const auto pointOf = [&](std::size_t k) {
        const glm::vec3 p = mesh.vertices[mesh.indices[k]].position;
        return Point(p.x, p.y, p.z);
    };
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3)
        for (std::size_t c = 0; c < 3; ++c)
            ++edges[{pointOf(k + c), pointOf(k + (c + 1) % 3)}];
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (edge.first == edge.second || count != 1 || back == edges.end())
            return false;
    }
    return !edges.empty();
}

TEST(ParametricMeshes, AreClosedAndFaceOutwards) {
    for (const SurfaceMesh& mesh : {makeSphere({1, 1}), makeSphere({5, 2}, {3, 2}),
                                    makeTorus({1, 1}), makeTorus({5, 2}, {3, 3})}) {
        EXPECT_TRUE(isClosed(mesh));
        for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
            const SurfaceVertex& a = mesh.vertices[mesh.indices[k]];
            const SurfaceVertex& b = mesh.vertices[mesh.indices[k + 1]];
            const SurfaceVertex& c = mesh.vertices[mesh.indices[k + 2]];
            const glm::vec3 winding = glm::cross(b.position - a.position, c.position - a.position);
            EXPECT_GT(glm::dot(winding, a.normal + b.normal + c.normal), 0.0f);
            // No triangle spans the seam.
            EXPECT_LT(std::abs(a.uv.x - b.uv.x), 0.5f * 5);
        }
    }
    SurfaceMesh open = makeTorus({1, 1});
    open.indices.resize(open.indices.size() - 3);
    EXPECT_FALSE(isClosed(open));
}

TEST(ParametricMeshes, AreAsWideAsTheBox) {
    for (const SurfaceMesh& mesh : {makeSphere({1, 1}), makeTorus({1, 1})}) {
        const SurfaceExtent extent = extentOf(mesh);
        EXPECT_FLOAT_EQ(extent.minimum.x, -0.5f);
        EXPECT_FLOAT_EQ(extent.maximum.y, 0.5f);
        EXPECT_EQ(mesh.windowMinimum.x, -kNoBorder);
        EXPECT_EQ(mesh.windowMaximum.y, kNoBorder);
    }
}

TEST(ParametricMeshes, TilesOfASphereShrinkToNothingAtThePoles) {
    const SurfaceMesh mesh = makeSphere({1, 1});
    EXPECT_EQ(mesh.vertices.front().tangent, glm::vec3(0.0f));
    EXPECT_EQ(mesh.vertices.back().tangent, glm::vec3(0.0f));
    EXPECT_EQ(mesh.vertices.front().position, glm::vec3(0, 0, 0.5f));
    EXPECT_NEAR(extentOf(mesh).widestTile, std::numbers::pi, 1e-5);
}

}  // namespace
}  // namespace relievo::surfaces
