#include "textures/sample_solids.h"

#include "textures/lattice_noise.h"

namespace relievo::textures {

namespace {

/// A solid that stands in a lattice cell: the distance of a point from its axis in tile widths, and
/// its random numbers.
struct Solid {
    double distance;
    std::uint32_t part;
    std::uint32_t seed;

    [[nodiscard]] double random(std::uint32_t which) const {
        return latticeRandom(static_cast<int>(part), 0, seed + which);
    }
};

/// Calls `visit` for the solids of the 3×3 lattice cells around (u,v), which stand up to `jitter`
/// cells from the centres of their cells.
template <class Visit>
void forEachSolid(double u, double v, int columns, double jitter, const SampleTile& tile,
                  Visit visit) {
    const int rows = tile.rows(columns);
    const int cellX = static_cast<int>(std::floor(u * columns));
    const int cellY = static_cast<int>(std::floor(v * rows));
    for (int j = cellY - 1; j <= cellY + 1; ++j)
        for (int i = cellX - 1; i <= cellX + 1; ++i) {
            const int wx = wrapCell(i, columns), wy = wrapCell(j, rows);
            const double shiftX = (2.0 * latticeRandom(wx, wy, tile.seed + 11u) - 1.0) * jitter;
            const double shiftY = (2.0 * latticeRandom(wx, wy, tile.seed + 12u) - 1.0) * jitter;
            const double dx = u - (i + 0.5 + shiftX) / columns;
            const double dy = (v - (j + 0.5 + shiftY) / rows) * tile.aspect;
            visit(Solid{std::sqrt(dx * dx + dy * dy), latticeHash(wx, wy, tile.seed + 13u),
                        tile.seed});
        }
}

}  // namespace

SampleSurface pillarSurface(double u, double v, const SampleTile& tile) {
    constexpr int kColumns = 6;
    const int rows = tile.rows(4);
    const double floor = 0.97 + 0.03 * gradientNoise(u * 4.0, v * rows, 4, rows, tile.seed + 3u);
    SampleSurface surface{std::min(floor, 1.0), 0.0, 0};
    forEachSolid(u, v, kColumns, 0.3, tile, [&](const Solid& pillar) {
        if (pillar.random(1) > 0.6)
            return;
        const double radius = 0.011 + 0.012 * pillar.random(2);
        const double top = 0.02 + 0.35 * pillar.random(3);
        // A bevel of a fifth of the radius, so that the walls are steep but not a single texel.
        const double body = smoothStep(radius, 0.8 * radius, pillar.distance);
        const double depth = std::lerp(surface.depth, top, body);
        if (depth < surface.depth)
            surface = {depth, body, pillar.part};
    });
    return surface;
}

SampleSurface spikeSurface(double u, double v, const SampleTile& tile) {
    constexpr int kColumns = 14;
    SampleSurface surface{1.0, 0.0, 0};
    forEachSolid(u, v, kColumns, 0.35, tile, [&](const Solid& spike) {
        const double radius = (0.55 + 0.4 * spike.random(1)) / kColumns;
        const double top = 0.45 * spike.random(2);
        const double depth = top + (1.0 - top) * spike.distance / radius;
        if (depth < surface.depth)
            surface = {depth, 1.0 - depth, spike.part};
    });
    return surface;
}

SampleSurface hemisphereSurface(double u, double v, const SampleTile& tile) {
    constexpr int kColumns = 4;
    constexpr double kRadius = 0.44 / kColumns;
    // An even number of rows, or the stagger would not meet itself across the seam.
    const int rows = std::max(2, 2 * ((tile.rows(kColumns) + 1) / 2));
    SampleSurface surface{1.0, 0.0, 0};
    const int row = static_cast<int>(std::floor(v * rows));
    for (int j = row - 1; j <= row + 1; ++j) {
        const double stagger = 0.25 + 0.5 * wrapCell(j, 2);
        const double along = u * kColumns - stagger;
        const double nearest = std::floor(along + 0.5);
        const double dx = (along - nearest) / kColumns;
        const double dy = (v - (j + 0.5) / rows) * tile.aspect;
        const double squared = 1.0 - (dx * dx + dy * dy) / (kRadius * kRadius);
        const double depth = squared > 0.0 ? 1.0 - std::sqrt(squared) : 1.0;
        if (depth < surface.depth)
            surface = {depth, 1.0,
                       latticeHash(wrapCell(static_cast<int>(nearest), kColumns), wrapCell(j, rows),
                                   tile.seed)};
    }
    return surface;
}

}  // namespace relievo::textures
