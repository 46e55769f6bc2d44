// A second channel that keeps the corners of outlines sharp: what is behind it, and a builder of it
// that is simple rather than fast.
//
// In a cell the zero level of a bilinear distance is a hyperbola, which no choice of the four
// samples bends around a corner: see CornerStudy. With a second channel e, f = d + clamp(e, 0, K)
// is continuous, costs no lookup where both channels are in one texel, and has two kinds of
// creases: f = max(A, B) of two bilinear fields where e crosses 0 (a convex corner, or a thin bar),
// and f = min(A, B) where e crosses K (a reflex corner, or a thin slit). Where all samples of a
// cell have e in [0, K], f is the bilinear interpolation of its samples as ever, so that a map
// without corners is what it was.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "outline_error.h"
#include "reference/plane_outline.h"

namespace relievo::preprocess {

/// K in texels.
inline constexpr double kCreaseLimit = 16.0;

/// The signed distance to the curve of an outline before (or behind) a corner, continued straight
/// at both ends.
class OutlineSide {
  public:
    /// From the corner, `step` = ±1 through the contour, to the next corner or as far as `reach`.
    OutlineSide(const reference::OutlineContour& contour, std::size_t corner, int step,
                double reach, bool isInsideLeft);
    [[nodiscard]] double distance(const glm::dvec2& place) const;
    /// Of unit length, from the corner.
    [[nodiscard]] glm::dvec2 direction() const;

  private:
    std::vector<glm::dvec2> points_;  // the corner second, before it the straight continuation
    double sign_;
};

/// What happens with the samples around corners.
enum class CornerMethod {
    Plain,    ///< the exact distances
    Planes,   ///< one channel: max (or min) of the distances to both sides of a corner
    Creased,  ///< two channels
};

struct CreaseStatistics {
    int corners = 0;    ///< kept sharp
    int dropped = 0;    ///< left round: something else is within a texel or two of them
    int samples = 0;    ///< with a crease
    int conflicts = 0;  ///< samples beside creases of both kinds, where one is not exact
};

/// `exact`: signed distances on texel centres. Contours in texels, their corners in order.
SampledDistance sampleDistance(const textures::Plane& exact,
                               const std::vector<reference::OutlineContour>& contours,
                               const std::vector<OutlineCorner>& corners,
                               const reference::PlaneOutline& outline, CornerMethod method,
                               CreaseStatistics* statistics = nullptr);

}  // namespace relievo::preprocess
