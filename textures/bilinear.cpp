#include "textures/bilinear.h"

#include <cassert>
#include <cmath>
#include <cstdint>

namespace relievo::textures {

namespace {

/// A coordinate in texels, split into the texel at or before it and the way to the next.
struct TexelCoordinate {
    std::int64_t index;
    double fraction;
};

TexelCoordinate split(double texels) {
    const double whole = std::floor(texels);
    return {static_cast<std::int64_t>(whole), texels - whole};
}

}  // namespace

double sampleBilinear(const Plane& plane, double u, double v, WrapMode wrap) {
    assert(plane.width > 0 && plane.height > 0);
    const TexelCoordinate x = split(u * plane.width - 0.5);
    const TexelCoordinate y = split(v * plane.height - 0.5);
    const int i0 = wrapIndex(x.index, plane.width, wrap);
    const int i1 = wrapIndex(x.index + 1, plane.width, wrap);
    const int j0 = wrapIndex(y.index, plane.height, wrap);
    const int j1 = wrapIndex(y.index + 1, plane.height, wrap);
    const double top = std::lerp(static_cast<double>(plane.at(i0, j0)),
                                 static_cast<double>(plane.at(i1, j0)), x.fraction);
    const double bottom = std::lerp(static_cast<double>(plane.at(i0, j1)),
                                    static_cast<double>(plane.at(i1, j1)), x.fraction);
    return std::lerp(top, bottom, y.fraction);
}

double sampleNearest(const Plane& plane, double u, double v, WrapMode wrap) {
    assert(plane.width > 0 && plane.height > 0);
    return plane.at(wrapIndex(split(u * plane.width).index, plane.width, wrap),
                    wrapIndex(split(v * plane.height).index, plane.height, wrap));
}

}  // namespace relievo::textures
