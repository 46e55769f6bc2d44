#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace relievo::reference {

/// A closed curve as a polyline: its last point joins its first. In tile widths, x to the right and
/// y downwards (y = ρ·v).
using OutlineContour = std::vector<glm::dvec2>;

/// Which points contours enclose: those around which they go, on balance, or an odd number of
/// times.
enum class Filling { NonZero, EvenOdd };

/// The nearest point of an outline.
struct NearestOutlinePoint {
    double distance = 0.0;      ///< < 0 inside; +infinity where there is no outline
    glm::dvec2 point{0.0};      ///< of the outline
    glm::dvec2 direction{0.0};  ///< in which the distance grows; unit length, (0,0) on the outline
    std::uint32_t segment = 0;  ///< number of the segment, contour by contour
};

/// Where a ray comes into the shape or goes out of it.
struct OutlineCrossing {
    double t = 0.0;
    glm::dvec2 normal{0.0};  ///< of the outline there, unit length, against the ray
};

/// A plane shape in double precision: what shape maps are measured against. Contours must not
/// cross each other or themselves (touching is allowed): every segment counts as the shape's end.
///
/// Segments are kept in a tree of boxes; answers are exact up to the rounding of doubles.
class PlaneOutline {
  public:
    /// Contours of less than three points are left out. Coordinates must be finite.
    explicit PlaneOutline(const std::vector<OutlineContour>& contours,
                          Filling filling = Filling::NonZero);

    /// Whether `place` is inside. On the outline either.
    [[nodiscard]] bool isInside(const glm::dvec2& place) const;
    [[nodiscard]] NearestOutlinePoint nearest(const glm::dvec2& place) const;
    /// The signed distance alone.
    [[nodiscard]] double distance(const glm::dvec2& place) const { return nearest(place).distance; }
    /// The first crossing of origin + t·direction with any segment for t in [from, to]. Rays pass
    /// between no two segments that share a point. Along segments they go without a crossing.
    [[nodiscard]] std::optional<OutlineCrossing> firstCrossing(const glm::dvec2& origin,
                                                               const glm::dvec2& direction,
                                                               double from, double to) const;

    struct Segment {
        glm::dvec2 start{0.0};
        glm::dvec2 end{0.0};
        std::uint32_t number = 0;
    };
    /// Segments halved along the longer side of their box, down to a few.
    struct Node {
        glm::dvec2 low{0.0};
        glm::dvec2 high{0.0};
        std::uint32_t first = 0;  ///< of a leaf its first segment, of others the second child
        std::uint32_t count = 0;  ///< of a leaf its segments; 0 of others: the next is a child
    };
    [[nodiscard]] const std::vector<Segment>& segments() const noexcept { return segments_; }
    [[nodiscard]] const std::vector<Node>& nodes() const noexcept { return nodes_; }

    /// Calls visit(segment) for the segments of all leaves on whose way isWanted(node) holds.
    template <class IsWanted, class Visit>
    void visitSegments(const IsWanted& isWanted, const Visit& visit) const {
        std::uint32_t stack[64];
        int size = 0;
        if (!nodes_.empty())
            stack[size++] = 0;
        while (size > 0) {
            const std::uint32_t number = stack[--size];
            const Node& node = nodes_[number];
            if (!isWanted(node))
                continue;
            for (std::uint32_t k = 0; k < node.count; ++k)
                visit(segments_[node.first + k]);
            if (node.count > 0)
                continue;
            stack[size++] = node.first;
            stack[size++] = number + 1;
        }
    }

  private:
    void build(std::uint32_t first, std::uint32_t count);

    std::vector<Segment> segments_;
    std::vector<Node> nodes_;
    Filling filling_;
};

}  // namespace relievo::reference
