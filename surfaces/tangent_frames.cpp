#include "surfaces/tangent_frames.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <tuple>

namespace relievo::surfaces {
namespace {

constexpr std::uint32_t kNowhere = ~std::uint32_t{0};
// Of the product of two lengths: what is less across is along one line.
constexpr double kLeastSine = 1e-6;
// The area of a tile beyond which shaders could not square it.
constexpr double kLargestTile = 1e18;

struct Triangle {
    std::array<std::uint32_t, 3> corners;
    glm::dvec3 normal;  ///< unit length
};

/// The derivatives of the position on one triangle, times the weight: twice its area in (u,v).
struct Derivatives {
    glm::dvec3 alongU{0.0};
    glm::dvec3 alongV{0.0};
    double weight = 0.0;

    Derivatives& operator+=(const Derivatives& other) {
        alongU += other.alongU;
        alongV += other.alongV;
        weight += other.weight;
        return *this;
    }
};

glm::dvec3 positionOf(const TriangleMesh& mesh, std::uint32_t vertex) {
    return glm::dvec3(mesh.positions[vertex]);
}

glm::dvec2 uvOf(const TriangleMesh& mesh, std::uint32_t vertex) {
    return mesh.uv.empty() ? glm::dvec2(0.0) : glm::dvec2(mesh.uv[vertex]);
}

// Those with an area.
std::vector<Triangle> trianglesOf(const TriangleMesh& mesh) {
    std::vector<Triangle> triangles;
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
        Triangle triangle{{mesh.indices[k], mesh.indices[k + 1], mesh.indices[k + 2]}, {}};
        const glm::dvec3 first = positionOf(mesh, triangle.corners[0]);
        const glm::dvec3 across = glm::cross(positionOf(mesh, triangle.corners[1]) - first,
                                             positionOf(mesh, triangle.corners[2]) - first);
        const double area = glm::length(across);
        if (!(area > 0.0))
            continue;
        triangle.normal = across / area;
        triangles.push_back(triangle);
    }
    return triangles;
}

// Twice the area in (u,v), positive where u, v and the normal are right-handed. v points downwards,
// so that plain uv have a negative one.
double uvArea(const TriangleMesh& mesh, const Triangle& triangle) {
    const glm::dvec2 first = uvOf(mesh, triangle.corners[0]);
    const glm::dvec2 a = uvOf(mesh, triangle.corners[1]) - first;
    const glm::dvec2 b = uvOf(mesh, triangle.corners[2]) - first;
    return a.x * b.y - a.y * b.x;
}

// edge = du·∂u + dv·∂v for two edges, solved for the derivatives.
Derivatives derivativesOn(const TriangleMesh& mesh, const Triangle& triangle) {
    const double area = uvArea(mesh, triangle);
    const glm::dvec3 first = positionOf(mesh, triangle.corners[0]);
    const glm::dvec2 firstUv = uvOf(mesh, triangle.corners[0]);
    const glm::dvec3 edgeA = positionOf(mesh, triangle.corners[1]) - first;
    const glm::dvec3 edgeB = positionOf(mesh, triangle.corners[2]) - first;
    const glm::dvec2 a = uvOf(mesh, triangle.corners[1]) - firstUv;
    const glm::dvec2 b = uvOf(mesh, triangle.corners[2]) - firstUv;
    const double sign = area < 0.0 ? -1.0 : 1.0;
    return {sign * (b.y * edgeA - a.y * edgeB), sign * (a.x * edgeB - b.x * edgeA), std::abs(area)};
}

double angleAt(const TriangleMesh& mesh, const Triangle& triangle, std::size_t corner) {
    const glm::dvec3 here = positionOf(mesh, triangle.corners[corner]);
    const glm::dvec3 a = positionOf(mesh, triangle.corners[(corner + 1) % 3]) - here;
    const glm::dvec3 b = positionOf(mesh, triangle.corners[(corner + 2) % 3]) - here;
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// For each vertex the first one that has its position.
std::vector<std::uint32_t> firstsOfPositions(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t vertex) {
        const glm::vec3& p = mesh.positions[vertex];
        return std::tuple(p.x, p.y, p.z);
    };
    std::ranges::stable_sort(order, {}, key);
    std::vector<std::uint32_t> firsts(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        firsts[order[k]] =
            k > 0 && key(order[k]) == key(order[k - 1]) ? firsts[order[k - 1]] : order[k];
    return firsts;
}

// Sums of the triangles' normals over the vertices that are the same to `placeOf`.
template <typename PlaceOf>
std::vector<glm::dvec3> sumNormals(const TriangleMesh& mesh, std::span<const Triangle> triangles,
                                   const PlaceOf& placeOf) {
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
    for (const Triangle& triangle : triangles)
        for (std::size_t corner = 0; corner < 3; ++corner)
            sums[placeOf(triangle.corners[corner])] +=
                angleAt(mesh, triangle, corner) * triangle.normal;
    return sums;
}

// A unit normal for every vertex that a triangle uses. The two sides of a sheet cancel each other
// where they share positions: those have the normals of their own vertices.
std::vector<glm::dvec3> normalsOf(const TriangleMesh& mesh, std::span<const Triangle> triangles) {
    const std::vector<std::uint32_t> firsts = firstsOfPositions(mesh);
    const auto byPosition =
        sumNormals(mesh, triangles, [&](std::uint32_t vertex) { return firsts[vertex]; });
    const auto byVertex = sumNormals(mesh, triangles, [](std::uint32_t vertex) { return vertex; });
    std::vector<glm::dvec3> normals(mesh.positions.size(), glm::dvec3(0.0));
    for (const Triangle& triangle : triangles)
        for (const std::uint32_t vertex : triangle.corners) {
            if (normals[vertex] != glm::dvec3(0.0))
                continue;
            const glm::dvec3 given =
                mesh.normals.empty() ? glm::dvec3(0.0) : glm::dvec3(mesh.normals[vertex]);
            for (const glm::dvec3& normal : {given, byPosition[firsts[vertex]], byVertex[vertex]})
                if (glm::length(normal) > kLeastSine) {
                    normals[vertex] = glm::normalize(normal);
                    break;
                }
            if (normals[vertex] == glm::dvec3(0.0))
                normals[vertex] = triangle.normal;
        }
    return normals;
}

/// Which vertices of the result stand for those of the input: one for each handedness of uv.
class VertexSplit {
  public:
    VertexSplit(const TriangleMesh& mesh, std::span<const Triangle> triangles)
        : places_(mesh.positions.size(), {kNowhere, kNowhere}) {
        for (const Triangle& triangle : triangles)
            if (const double area = uvArea(mesh, triangle); area != 0.0)
                use(triangle, area > 0.0 ? 1 : 0);
        // Triangles that have no handedness take part in what there is.
        for (const Triangle& triangle : triangles)
            for (const std::uint32_t vertex : triangle.corners)
                if (places_[vertex] == std::array{kNowhere, kNowhere})
                    places_[vertex][0] = 0;
        for (std::uint32_t vertex = 0; vertex < places_.size(); ++vertex)
            for (std::uint32_t& place : places_[vertex])
                if (place != kNowhere) {
                    place = static_cast<std::uint32_t>(sources_.size());
                    sources_.push_back(vertex);
                }
    }

    /// The vertex of the result at a corner of a triangle with that area in (u,v).
    [[nodiscard]] std::uint32_t at(std::uint32_t vertex, double uvArea) const {
        const std::array<std::uint32_t, 2>& places = places_[vertex];
        const std::size_t wanted = uvArea > 0.0 ? 1 : 0;
        return places[wanted] != kNowhere ? places[wanted] : places[1 - wanted];
    }
    /// The vertex of the input for each one of the result.
    [[nodiscard]] const std::vector<std::uint32_t>& sources() const noexcept { return sources_; }

  private:
    void use(const Triangle& triangle, std::size_t hand) {
        for (const std::uint32_t vertex : triangle.corners)
            places_[vertex][hand] = 0;
    }

    std::vector<std::array<std::uint32_t, 2>> places_;  // plain, mirrored
    std::vector<std::uint32_t> sources_;
};

// A unit vector across `normal`.
glm::dvec3 acrossOf(const glm::dvec3& normal) {
    const glm::dvec3 axis = std::abs(normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(axis, normal));
}

void setFrame(SurfaceVertex& vertex, const Derivatives& sum, const glm::dvec3& normal) {
    vertex.normal = glm::vec3(normal);
    const auto across = [&](const glm::dvec3& v) { return v - glm::dot(v, normal) * normal; };
    const glm::dvec3 tangent = across(sum.alongU / sum.weight);
    const glm::dvec3 bitangent = across(sum.alongV / sum.weight);
    const double area = glm::length(glm::cross(tangent, bitangent));
    // Also false for those that are not finite.
    if (area > kLeastSine * glm::length(tangent) * glm::length(bitangent) && area < kLargestTile) {
        vertex.tangent = glm::vec3(tangent);
        vertex.bitangent = glm::vec3(bitangent);
        return;
    }
    const glm::dvec3 right = acrossOf(normal);
    vertex.tangent = kTinyTile * glm::vec3(right);
    vertex.bitangent = kTinyTile * glm::vec3(glm::cross(right, normal));
}

}  // namespace

SurfaceMesh withTangentFrames(const TriangleMesh& mesh) {
    assert(mesh.uv.empty() || mesh.uv.size() == mesh.positions.size());
    assert(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
    const std::vector<Triangle> triangles = trianglesOf(mesh);
    const std::vector<glm::dvec3> normals = normalsOf(mesh, triangles);
    const VertexSplit split(mesh, triangles);
    SurfaceMesh result;
    result.windowMinimum = glm::vec2(-kNoBorder);
    result.windowMaximum = glm::vec2(kNoBorder);
    std::vector<Derivatives> sums(split.sources().size());
    for (const Triangle& triangle : triangles) {
        const double area = uvArea(mesh, triangle);
        const Derivatives derivatives = derivativesOn(mesh, triangle);
        for (const std::uint32_t corner : triangle.corners) {
            const std::uint32_t place = split.at(corner, area);
            result.indices.push_back(place);
            sums[place] += derivatives;
        }
    }
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const std::uint32_t source = split.sources()[k];
        SurfaceVertex& vertex = result.vertices.emplace_back();
        vertex.position = mesh.positions[source];
        vertex.uv = glm::vec2(uvOf(mesh, source));
        setFrame(vertex, sums[k], normals[source]);
    }
    return result;
}

}  // namespace relievo::surfaces
