#include "materials/detail_choice.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace relievo::materials {
namespace {

// Row `index` of a matrix without its last column: what a direction is multiplied by.
glm::dvec3 row(const glm::mat4& matrix, int index) {
    return {matrix[0][index], matrix[1][index], matrix[2][index]};
}

// The least w of the clip coordinates of the box, which is linear, so at a corner.
double leastW(const surfaces::SurfaceExtent& extent, const glm::mat4& matrix) {
    double least = matrix[3][3];
    for (int axis = 0; axis < 3; ++axis)
        least += std::min(
            static_cast<double>(matrix[axis][3]) * static_cast<double>(extent.minimum[axis]),
            static_cast<double>(matrix[axis][3]) * static_cast<double>(extent.maximum[axis]));
    return least;
}

}  // namespace

// A point x = (row 0·p)/(row 3·p) of the picture, in [−1,1], moves along a unit vector n by
// (row 0·n − x·row 3·n)/w, which is at most (|row 0| + |row 3|)/w; a pixel is 2/pixels of that.
double greatestShift(const surfaces::SurfaceExtent& extent, const DrawnView& view, double length) {
    const double w = leastW(extent, view.viewProjection);
    if (!(w > 0.0))
        return std::numeric_limits<double>::infinity();
    const double depth = glm::length(row(view.viewProjection, 3));
    const glm::dvec2 shift{glm::length(row(view.viewProjection, 0)) + depth,
                           glm::length(row(view.viewProjection, 1)) + depth};
    return length * glm::length(0.5 * glm::dvec2(view.pixels) * shift) / w;
}

ReliefMaterial materialForDraw(const ReliefMaterial& material,
                               const surfaces::SurfaceExtent& extent, const DrawnView& view) {
    if (&material.technique() != &findTechnique("auto"))
        return material;
    if (material.shadow() && material.shadow()->searches)
        return material.shownBy(findTechnique("exact"));
    const glm::dvec2 range(material.maps().depthRange());
    const double halfDepth = 0.5 * (range.y - range.x) * static_cast<double>(material.depthScale) *
                             static_cast<double>(extent.widestTile);
    const bool isFar = greatestShift(extent, view, halfDepth) <= material.parameter("pixel-error");
    return isFar ? material.shownBy(middleTechnique()) : material;
}

}  // namespace relievo::materials
