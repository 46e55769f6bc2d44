#include "preprocess/plane_shape.h"

#include <cmath>
#include <polyclipping/clipper.hpp>

namespace relievo::preprocess {
namespace {

using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;
using textures::WrapMode;

constexpr double kUnits =
    268435456.0;  // of a tile width: within what Clipper multiplies in 64 bits

struct Tile {
    cInt width;
    cInt height;
};

Paths pathsOf(const outlines::Outline& outline) {
    Paths paths;
    for (const outlines::Contour& contour : outline.contours) {
        Path& path = paths.emplace_back();
        for (const glm::dvec2& point : contour)
            path.emplace_back(std::llround(point.x * kUnits), std::llround(point.y * kUnits));
    }
    return paths;
}

Path rectangle(cInt left, cInt top, cInt right, cInt bottom) {
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

Paths clippedTo(const Path& window, const Paths& paths, ClipperLib::PolyFillType rule) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(paths, ClipperLib::ptSubject, true);
    clipper.AddPath(window, ClipperLib::ptClip, true);
    Paths result;
    clipper.Execute(ClipperLib::ctIntersection, result, rule, ClipperLib::pftNonZero);
    return result;
}

// A path of the tile as copy (i,j) has it, i and j from −1 to 1.
Path copied(const Path& path, const Tile& tile, int i, int j, WrapMode wrap) {
    Path result;
    const bool isMirrored = wrap == WrapMode::Mirror;
    for (const IntPoint& point : path) {
        const cInt x = isMirrored && i != 0 ? tile.width - point.X : point.X;
        const cInt y = isMirrored && j != 0 ? tile.height - point.Y : point.Y;
        result.emplace_back(x + i * tile.width, y + j * tile.height);
    }
    // Every path goes around its inside in the same direction, mirrored or not.
    if (isMirrored && (i != 0) != (j != 0))
        ClipperLib::ReversePath(result);
    return result;
}

Paths withCopies(const Paths& paths, const Tile& tile, WrapMode wrap) {
    ClipperLib::Clipper clipper;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
            for (const Path& path : paths)
                clipper.AddPath(copied(path, tile, i, j, wrap), ClipperLib::ptSubject, true);
    Paths result;
    clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return result;
}

// Whether a segment lies on a side of the rectangle of `copies` tiles on each side of the tile.
bool isOnSide(const IntPoint& a, const IntPoint& b, const Tile& tile, int copies) {
    const auto isSide = [copies](cInt place, cInt length) {
        return place == -copies * length || place == (1 + copies) * length;
    };
    return (a.X == b.X && isSide(a.X, tile.width)) || (a.Y == b.Y && isSide(a.Y, tile.height));
}

}  // namespace

PlaneShape shapeOf(const outlines::Outline& outline, int width, int height, WrapMode wrap) {
    const double texel = kUnits / width;
    const Tile tile{static_cast<cInt>(kUnits), std::llround(texel * height)};
    const auto rule = outline.rule == outlines::FillRule::NonZero ? ClipperLib::pftNonZero
                                                                  : ClipperLib::pftEvenOdd;
    Paths paths = clippedTo(rectangle(0, 0, tile.width, tile.height), pathsOf(outline), rule);
    const int copies = wrap == WrapMode::Clamp ? 0 : 1;
    if (copies > 0)
        paths = withCopies(paths, tile, wrap);
    PlaneShape shape;
    for (const Path& path : paths)
        for (std::size_t k = 0; k < path.size(); ++k) {
            const IntPoint& a = path[k];
            const IntPoint& b = path[(k + 1) % path.size()];
            const glm::dvec2 start(static_cast<double>(a.X), static_cast<double>(a.Y));
            const glm::dvec2 end(static_cast<double>(b.X), static_cast<double>(b.Y));
            shape.edges.push_back({start / texel, end / texel});
            if (!isOnSide(a, b, tile, copies))
                shape.boundary.push_back(shape.edges.back());
        }
    return shape;
}

}  // namespace relievo::preprocess
