#include "surfaces/parametric_meshes.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace relievo::surfaces {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// The angle at a share of a whole turn; the end is exactly where the start is.
double angleOf(double share) {
    return kTurn * (share - std::floor(share));
}

/// A point of a surface over the unit square, with its partial derivatives.
struct SurfacePoint {
    glm::dvec3 position;
    glm::dvec3 alongS;
    glm::dvec3 alongT;
    glm::dvec3 normal;
};

/// A direction in the plane of x and y, and the one a quarter of a turn on.
struct Spoke {
    glm::dvec3 outwards;
    glm::dvec3 onwards;
};

Spoke spokeAt(double s) {
    const double angle = angleOf(s);
    return {{std::cos(angle), std::sin(angle), 0.0}, {-std::sin(angle), std::cos(angle), 0.0}};
}

constexpr glm::dvec3 kUp{0, 0, 1};

SurfacePoint spherePoint(double s, double t) {
    const Spoke spoke = spokeAt(s);
    const double angle = std::numbers::pi * t;
    // Exactly nothing at the lower pole, too.
    const double sine = t == 1.0 ? 0.0 : std::sin(angle);
    const double cosine = std::cos(angle);
    SurfacePoint point;
    point.normal = sine * spoke.outwards + cosine * kUp;
    point.position = double{kSphereRadius} * point.normal;
    point.alongS = kSphereRadius * kTurn * sine * spoke.onwards;
    point.alongT = kSphereRadius * std::numbers::pi * (cosine * spoke.outwards - sine * kUp);
    return point;
}

SurfacePoint torusPoint(double s, double t) {
    const Spoke spoke = spokeAt(s);
    const double angle = std::numbers::pi - angleOf(t);
    SurfacePoint point;
    point.normal = std::cos(angle) * spoke.outwards + std::sin(angle) * kUp;
    point.position = double{kTorusRadius} * spoke.outwards + double{kTubeRadius} * point.normal;
    point.alongS = kTurn * (kTorusRadius + kTubeRadius * std::cos(angle)) * spoke.onwards;
    point.alongT = kTubeRadius * kTurn * (std::sin(angle) * spoke.outwards - std::cos(angle) * kUp);
    return point;
}

SurfaceVertex vertexOf(const SurfacePoint& point, double s, double t, Tiles tiles) {
    return {glm::vec3(point.position), glm::vec3(point.normal),
            glm::vec3(point.alongS / double{tiles.x}), glm::vec3(point.alongT / double{tiles.y}),
            glm::vec2(s, t) * tiles};
}

// The first and the last row may be a single point each. There every triangle has a vertex of its
// own, in the middle of its column, so that u does not lean to one side.
template <typename PointAt>
SurfaceMesh gridMesh(const PointAt& pointAt, Tiles tiles, Divisions divisions, bool hasPoles) {
    const auto [columns, rows] = divisions;
    assert(tiles.x > 0 && tiles.y > 0 && columns >= 3 && rows >= 2);
    SurfaceMesh mesh;
    mesh.windowMinimum = glm::vec2(-kNoBorder);
    mesh.windowMaximum = glm::vec2(kNoBorder);
    std::vector<std::uint32_t> rowStart;
    for (int row = 0; row <= rows; ++row) {
        rowStart.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        const bool isPole = hasPoles && (row == 0 || row == rows);
        const double t = static_cast<double>(row) / rows;
        for (int column = 0; column < (isPole ? columns : columns + 1); ++column) {
            const double s = (column + (isPole ? 0.5 : 0.0)) / columns;
            mesh.vertices.push_back(vertexOf(pointAt(s, t), s, t, tiles));
        }
    }
    for (int row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(columns); ++column) {
            const std::uint32_t top = rowStart[static_cast<std::size_t>(row)] + column;
            const std::uint32_t bottom = rowStart[static_cast<std::size_t>(row) + 1] + column;
            if (!hasPoles || row < rows - 1)
                mesh.indices.insert(mesh.indices.end(), {top, bottom, bottom + 1});
            if (!hasPoles || row > 0)
                mesh.indices.insert(
                    mesh.indices.end(),
                    {top, hasPoles && row == rows - 1 ? bottom : bottom + 1, top + 1});
        }
    return mesh;
}

}  // namespace

SurfaceMesh makeSphere(Tiles tiles, Divisions divisions) {
    return gridMesh(spherePoint, tiles, divisions, true);
}

SurfaceMesh makeTorus(Tiles tiles, Divisions divisions) {
    assert(divisions.rows >= 3);
    return gridMesh(torusPoint, tiles, divisions, false);
}

}  // namespace relievo::surfaces
