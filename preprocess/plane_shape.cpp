#include "preprocess/plane_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "preprocess/boundary_reach.h"
#include "textures/input_error.h"

namespace relievo::preprocess {
namespace {

using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;
using textures::WrapMode;

constexpr double kUnits =
    268435456.0;                   // of a tile width: within what Clipper multiplies in 64 bits
constexpr double kFarthest = 1e6;  // tile widths: within the 62 bits of its coordinates

struct Tile {
    cInt width;
    cInt height;
};

void requirePlace(const glm::dvec2& point) {
    if (!(std::abs(point.x) <= kFarthest && std::abs(point.y) <= kFarthest))
        throw textures::InputError(
            fmt::format("the outline has a point at ({}, {}) tile widths, expected none beyond {}",
                        point.x, point.y, kFarthest));
}

Paths pathsOf(const outlines::Outline& outline) {
    Paths paths;
    for (const outlines::Contour& contour : outline.contours) {
        Path& path = paths.emplace_back();
        for (const glm::dvec2& point : contour) {
            requirePlace(point);
            path.emplace_back(std::llround(point.x * kUnits), std::llround(point.y * kUnits));
        }
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

Path moved(Path path, cInt x, cInt y) {
    for (IntPoint& point : path) {
        point.X += x;
        point.Y += y;
    }
    return path;
}

// The union of the paths, and of their copies in the tiles up to `copies` away.
Paths united(const Paths& paths, const Tile& tile, int copies) {
    ClipperLib::Clipper clipper;
    for (int j = -copies; j <= copies; ++j)
        for (int i = -copies; i <= copies; ++i)
            for (const Path& path : paths)
                clipper.AddPath(moved(path, i * tile.width, j * tile.height), ClipperLib::ptSubject,
                                true);
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

PlaneShape shapeOf(const outlines::Drawing& drawing, int width, int height, WrapMode wrap) {
    const double texel = kUnits / width;
    const Tile tile{static_cast<cInt>(kUnits), std::llround(texel * height)};
    const Path window = rectangle(0, 0, tile.width, tile.height);
    Paths paths;
    for (const outlines::Outline& outline : drawing.shapes) {
        const auto rule = outline.rule == outlines::FillRule::NonZero ? ClipperLib::pftNonZero
                                                                      : ClipperLib::pftEvenOdd;
        std::ranges::move(clippedTo(window, pathsOf(outline), rule), std::back_inserter(paths));
    }
    // Under mirror the nearest place is never one behind a border: it has an image before it.
    const int copies = wrap == WrapMode::Repeat ? 1 : 0;
    PlaneShape shape;
    for (const Path& path : united(paths, tile, copies))
        for (std::size_t k = 0; k < path.size(); ++k) {
            const IntPoint& a = path[k];
            const IntPoint& b = path[(k + 1) % path.size()];
            const glm::dvec2 start(static_cast<double>(a.X), static_cast<double>(a.Y));
            const glm::dvec2 end(static_cast<double>(b.X), static_cast<double>(b.Y));
            shape.edges.push_back({start / texel, end / texel});
            if (!isOnSide(a, b, tile, copies))
                shape.boundary.push_back(shape.edges.back());
        }
    if (copies > 0) {
        const double reach = boundaryReach(shape.boundary, width, height);
        std::erase_if(shape.boundary, [&](const BoundarySegment& segment) {
            return !isNearTile(segment, glm::dvec2(width, height), reach);
        });
    }
    return shape;
}

PlaneShape shapeOf(const outlines::Outline& outline, int width, int height, WrapMode wrap) {
    return shapeOf(outlines::Drawing{{outline}, static_cast<double>(height) / width}, width, height,
                   wrap);
}

}  // namespace relievo::preprocess
