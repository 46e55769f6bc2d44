#include "textures/sample_masonry.h"

#include <array>

#include "textures/lattice_noise.h"

namespace relievo::textures {

namespace {

/// Fine roughness in about [-1,1], the same for all masonry.
double grain(double u, double v, const SampleTile& tile) {
    const int columns = 32;
    const int rows = tile.rows(columns);
    return fractalNoise(u * columns, v * rows, columns, rows, 3, tile.seed + 77u);
}

/// Distance from (x,y) to a rectangle of half sizes (halfX,halfY) with rounded corners, negative
/// inside.
double roundedBox(double x, double y, double halfX, double halfY, double radius) {
    const double dx = std::abs(x) - halfX + radius;
    const double dy = std::abs(y) - halfY + radius;
    const double outside =
        std::sqrt(std::max(dx, 0.0) * std::max(dx, 0.0) + std::max(dy, 0.0) * std::max(dy, 0.0));
    return outside + std::min(std::max(dx, dy), 0.0) - radius;
}

struct Point {
    double x;
    double y;
};

/// The point of a Voronoi cell, in units of cells.
Point cellPoint(int x, int y, int columns, int rows, std::uint32_t seed) {
    const int wx = wrapCell(x, columns), wy = wrapCell(y, rows);
    return {x + 0.15 + 0.7 * latticeRandom(wx, wy, seed),
            y + 0.15 + 0.7 * latticeRandom(wx, wy, seed + 1u)};
}

double squaredDistance(const Point& a, const Point& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

struct VoronoiCell {
    double toBorder;  ///< distance to the border of the cell, in cells, rounded at its corners
    std::uint32_t part;
};

/// The minimum, lowered where the two are within `width` so that it has no crease.
double smoothMinimum(double a, double b, double width) {
    const double near = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - 0.25 * near * near * width;
}

/// The Voronoi cell that holds (x,y). The distance to the border with a neighbour is that to the
/// bisector of the two points, which gives joints of one width.
VoronoiCell voronoiCell(double x, double y, int columns, int rows, std::uint32_t seed) {
    const Point here{x, y};
    const int cellX = static_cast<int>(std::floor(x)), cellY = static_cast<int>(std::floor(y));
    int nearestX = 0, nearestY = 0;
    double least = 1e9;
    for (int j = cellY - 1; j <= cellY + 1; ++j)
        for (int i = cellX - 1; i <= cellX + 1; ++i) {
            const double squared = squaredDistance(here, cellPoint(i, j, columns, rows, seed));
            if (squared < least) {
                least = squared;
                nearestX = i;
                nearestY = j;
            }
        }
    const Point own = cellPoint(nearestX, nearestY, columns, rows, seed);
    double toBorder = 1e9;
    for (int j = nearestY - 2; j <= nearestY + 2; ++j)
        for (int i = nearestX - 2; i <= nearestX + 2; ++i) {
            if (i == nearestX && j == nearestY)
                continue;
            const Point other = cellPoint(i, j, columns, rows, seed);
            const double along = (squaredDistance(here, other) - squaredDistance(here, own)) /
                                 (2.0 * std::sqrt(squaredDistance(own, other)));
            toBorder = smoothMinimum(toBorder, along, 0.3);
        }
    return {toBorder,
            latticeHash(wrapCell(nearestX, columns), wrapCell(nearestY, rows), seed + 2u)};
}

double fractionOf(std::uint32_t part) {
    return (part & 0xFFFFu) / 65536.0;
}

}  // namespace

SampleSurface brickSurface(double u, double v, const SampleTile& tile) {
    constexpr int kColumns = 4;
    // An even number of courses, or the bond would not meet itself across the seam.
    const int rows = 2 * tile.rows(kColumns);
    const double course = v * rows;
    const int row = static_cast<int>(std::floor(course));
    const double along = u * kColumns + 0.5 * (row % 2);
    const int column = static_cast<int>(std::floor(along));
    const std::uint32_t part =
        latticeHash(wrapCell(column, kColumns), wrapCell(row, rows), tile.seed);

    // Lengths in tile widths from here on; the noise wears the edges.
    const double width = 1.0 / kColumns, height = tile.aspect / rows;
    const double x = (along - column - 0.5) * width;
    const double y = (course - row - 0.5) * height;
    const int wearRows = tile.rows(16);
    const double wear = fractalNoise(u * 16.0, v * wearRows, 16, wearRows, 3, tile.seed + 5u);
    const double joint = 0.055 * height;
    const double outside =
        roundedBox(x, y, 0.5 * width - joint, 0.5 * height - joint, 0.09 * height) +
        0.025 * height * wear;
    const double face = smoothStep(0.0, -0.12 * height, outside);

    const double rough = grain(u, v, tile);
    const double tilt =
        (fractionOf(part) - 0.5) * x / width + (fractionOf(part >> 16u) - 0.5) * y / height;
    const double top = 0.08 + 0.14 * fractionOf(part >> 8u) + 0.12 * tilt + 0.035 * rough;
    const double mortar = 0.9 + 0.05 * rough;
    return {std::clamp(std::lerp(mortar, top, face), 0.0, 1.0), face, part};
}

SampleSurface cobbleSurface(double u, double v, const SampleTile& tile) {
    constexpr int kColumns = 7;
    const int rows = tile.rows(kColumns);
    const VoronoiCell cell = voronoiCell(u * kColumns, v * rows, kColumns, rows, tile.seed);
    const double rough = grain(u, v, tile);
    const double inside = std::clamp((cell.toBorder + 0.02 * rough - 0.03) / 0.33, 0.0, 1.0);
    // A quarter of an ellipse: steep at the joint, level at the top.
    const double dome = std::sqrt(inside * (2.0 - inside));
    const double top = 0.04 + 0.2 * fractionOf(cell.part) + 0.03 * rough;
    const double joint = 0.93 + 0.05 * rough;
    return {std::clamp(std::lerp(joint, top, dome), 0.0, 1.0), smoothStep(0.0, 0.15, inside),
            cell.part};
}

SampleSurface blockSurface(double u, double v, const SampleTile& tile) {
    // A cell is a block, or is divided in four, twice at most.
    constexpr std::array kColumns{4, 8, 16};
    std::uint32_t part = 0;
    for (std::size_t level = 0; level < kColumns.size(); ++level) {
        const int columns = kColumns[level];
        const int rows = tile.rows(kColumns[0]) * (columns / kColumns[0]);
        const int x = static_cast<int>(std::floor(u * columns));
        const int y = static_cast<int>(std::floor(v * rows));
        part = latticeHash(x, y, tile.seed + static_cast<std::uint32_t>(level));
        if ((part >> 24u) < 110u)
            break;
    }
    const double height = fractionOf(part);
    return {0.03 + 0.94 * height, 1.0 - 0.6 * height, part};
}

}  // namespace relievo::textures
