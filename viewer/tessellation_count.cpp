#include "viewer/tessellation_count.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <polyclipping/clipper.hpp>

namespace relievo::viewer {
namespace {

using ClipperLib::cInt;
using ClipperLib::Path;
using ClipperLib::Paths;
using textures::WrapMode;

constexpr double kUnits = 268435456.0;  // of a tile width

Path pathOf(const outlines::Contour& contour) {
    Path path;
    for (const glm::dvec2& point : contour)
        path.emplace_back(std::llround(point.x * kUnits), std::llround(point.y * kUnits));
    return path;
}

Path rectangle(cInt width, cInt height) {
    return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

// A shape of the drawing, merged by its own rule and cut to the tile.
Paths cutToTile(const outlines::Outline& outline, const Path& tile) {
    ClipperLib::Clipper clipper;
    for (const outlines::Contour& contour : outline.contours)
        clipper.AddPath(pathOf(contour), ClipperLib::ptSubject, true);
    clipper.AddPath(tile, ClipperLib::ptClip, true);
    Paths result;
    const auto rule = outline.rule == outlines::FillRule::NonZero ? ClipperLib::pftNonZero
                                                                  : ClipperLib::pftEvenOdd;
    clipper.Execute(ClipperLib::ctIntersection, result, rule, ClipperLib::pftNonZero);
    return result;
}

// A path of the tile as tile (i,j) has it.
Path copied(const Path& path, cInt width, cInt height, int i, int j, WrapMode wrap) {
    const bool flipsX = wrap == WrapMode::Mirror && i % 2 != 0;
    const bool flipsY = wrap == WrapMode::Mirror && j % 2 != 0;
    Path result;
    for (const ClipperLib::IntPoint& point : path)
        result.emplace_back((flipsX ? width - point.X : point.X) + i * width,
                            (flipsY ? height - point.Y : point.Y) + j * height);
    // Every path goes around its inside in the same direction, mirrored or not.
    if (flipsX != flipsY)
        ClipperLib::ReversePath(result);
    return result;
}

Paths inTiles(const Paths& tile, cInt width, cInt height, const glm::dvec2& tiles, WrapMode wrap) {
    Paths result;
    for (int j = 0; j < tiles.y; ++j)
        for (int i = 0; i < tiles.x; ++i)
            for (const Path& path : tile)
                result.push_back(copied(path, width, height, i, j, wrap));
    return result;
}

outlines::Contour contourOf(const Path& path) {
    outlines::Contour contour;
    for (const ClipperLib::IntPoint& point : path)
        contour.emplace_back(static_cast<double>(point.X) / kUnits,
                             static_cast<double>(point.Y) / kUnits);
    return contour;
}

double distanceToSegment(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double share =
        length2 > 0.0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::length(point - a - share * along);
}

std::vector<glm::dvec2> knotsOf(const solids::Profile& profile, double tileWidth, double depth) {
    std::vector<glm::dvec2> knots;
    const auto append = [&](double z, double offset) {
        const glm::dvec2 knot(z * depth, offset * tileWidth);
        if (knots.empty() || knots.back() != knot)
            knots.push_back(knot);
    };
    for (const solids::ProfilePiece& piece : profile.pieces) {
        append(piece.top, piece.topOffset);
        append(piece.bottom, piece.bottomOffset);
    }
    return knots;
}

double farthestFromAxis(const ShapeBoundary& section) {
    double radius = 0.0;
    for (const outlines::Contour& contour : section.contours)
        for (const glm::dvec2& point : contour)
            radius = std::max(radius, point.x);
    return radius;
}

}  // namespace

ShapeBoundary boundaryOf(const outlines::Drawing& drawing, const glm::dvec2& tiles, WrapMode wrap) {
    const cInt width = static_cast<cInt>(kUnits);
    const cInt height = std::llround(kUnits * drawing.aspect);
    const glm::dvec2 window = wrap == WrapMode::Clamp ? glm::min(tiles, glm::dvec2(1.0)) : tiles;
    ClipperLib::Clipper clipper;
    for (const outlines::Outline& shape : drawing.shapes)
        clipper.AddPaths(
            inTiles(cutToTile(shape, rectangle(width, height)), width, height, window, wrap),
            ClipperLib::ptSubject, true);
    // First the union, so that tiles join, then the cut.
    Paths whole;
    clipper.Execute(ClipperLib::ctUnion, whole, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    ClipperLib::Clipper cutter;
    cutter.AddPaths(whole, ClipperLib::ptSubject, true);
    cutter.AddPath(rectangle(std::llround(window.x * kUnits),
                             std::llround(window.y * kUnits * drawing.aspect)),
                   ClipperLib::ptClip, true);
    ClipperLib::PolyTree tree;
    cutter.Execute(ClipperLib::ctIntersection, tree, ClipperLib::pftNonZero,
                   ClipperLib::pftNonZero);
    ShapeBoundary boundary;
    for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr;
         node = node->GetNext()) {
        boundary.contours.push_back(contourOf(node->Contour));
        boundary.vertices += node->Contour.size();
        boundary.holes += node->IsHole() ? 1 : 0;
    }
    return boundary;
}

std::size_t extrusionTriangles(const ShapeBoundary& boundary, std::size_t profileChords) {
    const std::size_t cap = boundary.vertices + 2 * boundary.holes - 2 * boundary.pieces();
    return 2 * cap + 2 * boundary.vertices * profileChords;
}

std::size_t revolutionTriangles(const ShapeBoundary& section, std::size_t sectors) {
    std::size_t triangles = 0;
    for (const outlines::Contour& contour : section.contours)
        for (std::size_t k = 0; k < contour.size(); ++k) {
            const double next = contour[(k + 1) % contour.size()].x;
            triangles += sectors * ((contour[k].x > 0.0 ? 1 : 0) + (next > 0.0 ? 1 : 0));
        }
    return triangles;
}

std::size_t circleSectors(double radius, double tolerance) {
    if (tolerance >= radius)
        return 3;
    const double steps = std::numbers::pi / std::acos(1.0 - tolerance / radius);
    return std::max<std::size_t>(3, static_cast<std::size_t>(std::ceil(steps)));
}

std::size_t profileChords(const solids::Profile& profile, double tileWidth, double depth,
                          double tolerance) {
    const std::vector<glm::dvec2> knots = knotsOf(profile, tileWidth, depth);
    const auto isWithin = [&](std::size_t first, std::size_t last) {
        return std::all_of(
            knots.begin() + static_cast<std::ptrdiff_t>(first),
            knots.begin() + static_cast<std::ptrdiff_t>(last), [&](const glm::dvec2& knot) {
                return distanceToSegment(knot, knots[first], knots[last]) <= tolerance;
            });
    };
    std::size_t chords = 0;
    for (std::size_t first = 0; first + 1 < knots.size(); ++chords) {
        std::size_t last = first + 1;
        while (last + 1 < knots.size() && isWithin(first, last + 1))
            ++last;
        first = last;
    }
    return chords;
}

std::optional<std::size_t> partTriangles(const SceneBox& box, const ScenePart& part,
                                         const SceneShape& shape) {
    if (shape.source == ShapeSource::Map)
        return std::nullopt;
    const double tolerance = kTessellationTolerance * glm::length(box.size);
    const glm::dvec3 tile = tileLengths(part.place);
    const glm::dvec3& tiles = part.place.tiles;
    const bool isRevolution = part.part.solid.kind == solids::SolidKind::Revolution;
    // The longer of what a tile width of the drawing is in the world, for drawings that are
    // squeezed.
    const double aspect = readShapeDrawing(shape, 1.0).aspect;
    const double scale = isRevolution ? std::max({tile.x, tile.y, tile.z / aspect})
                                      : std::max(tile.x, tile.y / aspect);
    const outlines::Drawing drawing = readShapeDrawing(shape, tolerance / scale);
    if (isRevolution) {
        const ShapeBoundary section = boundaryOf(drawing, glm::dvec2(1.0), WrapMode::Clamp);
        const double radius = std::max(tile.x, tile.y) * farthestFromAxis(section);
        const double replicas = tiles.x * tiles.y * tiles.z;
        return static_cast<std::size_t>(replicas) *
               revolutionTriangles(section, circleSectors(radius, tolerance));
    }
    return extrusionTriangles(boundaryOf(drawing, {tiles.x, tiles.y}, shape.wrap),
                              profileChords(part.part.solid.profile, scale, tile.z, tolerance));
}

SceneTriangles countTriangles(const SceneFile& scene) {
    SceneTriangles count;
    for (const SceneBox& box : scene.boxes) {
        const std::size_t copies = box.wholeToWorld.size();
        count.boxes += copies;
        count.drawn += 12 * copies;
        for (const ScenePart& part : box.parts) {
            const auto triangles = partTriangles(box, part, scene.shapes.at(part.shape));
            count.tessellated += copies * triangles.value_or(0);
            count.uncounted += triangles ? 0 : copies;
        }
    }
    return count;
}

}  // namespace relievo::viewer
