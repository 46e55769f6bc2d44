#include "reference/shape_cell.h"

#include <algorithm>
#include <cmath>

namespace relievo::reference {
namespace {

BilinearCell cellOf(const std::array<double, 4>& samples) noexcept {
    return {samples[0], samples[1], samples[2], samples[3]};
}

std::array<double, 4> samplesOf(const textures::Plane& plane, int left, int right, int top,
                                int bottom) noexcept {
    return {plane.at(left, top), plane.at(right, top), plane.at(left, bottom),
            plane.at(right, bottom)};
}

}  // namespace

const BilinearCell& ShapeCell::at(const glm::dvec2& p) const noexcept {
    if (join == Join::Same)
        return a;
    return (a.depth(p) > b.depth(p)) == (join == Join::Larger) ? a : b;
}

BilinearCell ShapeCell::difference() const noexcept {
    const double corner = a.corner - b.corner;
    const glm::dvec2 slope = a.slope - b.slope;
    return {corner, corner + slope.x, corner + slope.y,
            corner + slope.x + slope.y + (a.twist - b.twist)};
}

ShapeCell shapeCell(const std::array<double, 4>& distances, const std::array<double, 4>& codes,
                    double texel) noexcept {
    const double least = textures::kLeastReflexTexels * texel;
    bool isReflex = false;
    for (const double code : codes)
        isReflex = isReflex || std::abs(code) >= least;
    std::array<double, 4> a = distances;
    std::array<double, 4> b = distances;
    bool hasA = false;
    bool hasB = false;
    for (std::size_t k = 0; k < codes.size(); ++k) {
        if (codes[k] == 0.0 || (isReflex && std::abs(codes[k]) < least))
            continue;
        const double size =
            std::max(0.0, std::abs(codes[k]) - (isReflex ? textures::kReflexTexels * texel : 0.0));
        // The other side is less than the distance at a convex corner, more at a reflex one.
        (codes[k] < 0.0 ? b : a)[k] += isReflex ? size : -size;
        (codes[k] < 0.0 ? hasA : hasB) = true;
    }
    if (!hasA || !hasB)
        return {cellOf(distances), cellOf(distances), ShapeCell::Join::Same};
    return {cellOf(a), cellOf(b), isReflex ? ShapeCell::Join::Smaller : ShapeCell::Join::Larger};
}

ShapeCell shapeCell(const textures::ShapeMap& map, int left, int right, int top,
                    int bottom) noexcept {
    const std::array<double, 4> distances = samplesOf(map.distance, left, right, top, bottom);
    if (!map.isCreased())
        return {cellOf(distances), cellOf(distances), ShapeCell::Join::Same};
    return shapeCell(distances, samplesOf(map.creases.code, left, right, top, bottom),
                     1.0 / map.width());
}

BilinearCell stepCell(const textures::ShapeMap& map, int left, int right, int top,
                      int bottom) noexcept {
    return cellOf(samplesOf(map.steps(), left, right, top, bottom));
}

}  // namespace relievo::reference
