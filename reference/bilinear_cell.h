#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace relievo::reference {

/// The surface between four neighbouring texel centres, in local texel coordinates p = (x,y) with
/// (0,0) on the first centre and (1,1) on the last:
/// D(p) = corner + slope.x·x + slope.y·y + twist·x·y.
struct BilinearCell {
    double corner = 0.0;
    glm::dvec2 slope{0.0};  ///< per texel
    double twist = 0.0;     ///< per texel²
    double minimum = 0.0;   ///< least depth of the cell: one of its corners

    /// From the depths of the centres; d10 is the neighbour in x, d01 the neighbour in y.
    BilinearCell(double d00, double d10, double d01, double d11) noexcept;

    [[nodiscard]] double depth(const glm::dvec2& p) const noexcept {
        return corner + slope.x * p.x + (slope.y + twist * p.x) * p.y;
    }
    /// ∂D/∂(x,y), per texel.
    [[nodiscard]] glm::dvec2 gradient(const glm::dvec2& p) const noexcept {
        return slope + twist * glm::dvec2(p.y, p.x);
    }
};

/// z − D along a line through a cell, where s is the parameter of the line:
/// constant + linear·s + quadratic·s², negative above the surface.
struct DepthBelowSurface {
    double constant = 0.0;
    double linear = 0.0;
    double quadratic = 0.0;
};

/// Restricts `cell` to the line (from.xy local texel coordinates, from.z depth) + s·direction.
DepthBelowSurface depthBelowSurface(const BilinearCell& cell, const glm::dvec3& from,
                                    const glm::dvec3& direction) noexcept;

/// The first s ≥ 0 at which the line is at or below the surface, for a line that is above it or on
/// it at s = 0; nothing when it never comes down.
std::optional<double> firstCrossing(const DepthBelowSurface& below) noexcept;

}  // namespace relievo::reference
