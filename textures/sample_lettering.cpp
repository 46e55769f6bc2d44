#include "textures/sample_lettering.h"

#include <array>
#include <span>

#include "textures/lattice_noise.h"

namespace relievo::textures {

namespace {

/// What a pen follows, in heights of a letter, y downwards: the line from (x0,y0) to (x1,y1), or
/// with radius > 0 the outline at that distance around the line, right of x = `left`.
struct Stroke {
    double x0, y0, x1, y1;
    double radius = 0.0;
    double left = -1.0;
};

constexpr std::array kR{Stroke{0.0, 0.0, 0.0, 1.0}, Stroke{0.0, 0.26, 0.3, 0.26, 0.26, 0.0},
                        Stroke{0.26, 0.52, 0.56, 1.0}};
constexpr std::array kE{Stroke{0.0, 0.0, 0.0, 1.0}, Stroke{0.0, 0.0, 0.5, 0.0},
                        Stroke{0.0, 0.5, 0.42, 0.5}, Stroke{0.0, 1.0, 0.5, 1.0}};
constexpr std::array kL{Stroke{0.0, 0.0, 0.0, 1.0}, Stroke{0.0, 1.0, 0.5, 1.0}};
constexpr std::array kI{Stroke{0.0, 0.0, 0.0, 1.0}};
constexpr std::array kV{Stroke{0.0, 0.0, 0.3, 1.0}, Stroke{0.6, 0.0, 0.3, 1.0}};
constexpr std::array kO{Stroke{0.3, 0.3, 0.3, 0.7, 0.3}};
constexpr std::array kDot{Stroke{0.0, 0.5, 0.0, 0.52}};

struct Letter {
    double x;  ///< of its left stroke
    std::span<const Stroke> strokes;
};

/// The word takes the width of the tile, with a dot before it repeats.
constexpr double kWordWidth = 6.0;
constexpr std::array kWord{Letter{0.2, kR},  Letter{1.1, kE},   Letter{1.95, kL},
                           Letter{2.8, kI},  Letter{3.15, kE},  Letter{3.95, kV},
                           Letter{4.85, kO}, Letter{5.75, kDot}};

double distanceToLine(double x, double y, const Stroke& line) {
    const double dx = line.x1 - line.x0, dy = line.y1 - line.y0;
    const double along = ((x - line.x0) * dx + (y - line.y0) * dy) / (dx * dx + dy * dy);
    const double t = std::clamp(along, 0.0, 1.0);
    const double ex = x - line.x0 - t * dx, ey = y - line.y0 - t * dy;
    return std::sqrt(ex * ex + ey * ey);
}

struct NearestLetter {
    double distance = 1e9;
    int number = 0;
};

/// How far (x,y) is from the strokes of the word, and which letter is nearest.
NearestLetter nearestLetter(double x, double y) {
    NearestLetter nearest;
    for (std::size_t number = 0; number < kWord.size(); ++number)
        for (const Stroke& stroke : kWord[number].strokes) {
            const double letterX = x - kWord[number].x;
            if (letterX < stroke.left)
                continue;
            const double line = distanceToLine(letterX, y, stroke);
            const double distance = stroke.radius > 0.0 ? std::abs(line - stroke.radius) : line;
            if (distance < nearest.distance)
                nearest = {distance, static_cast<int>(number)};
        }
    return nearest;
}

}  // namespace

SampleSurface letteringSurface(double u, double v, const SampleTile& tile) {
    constexpr double kShare = 2.0 / 3.0;  // of the row that the letters take
    const int rows = tile.rows(4);
    const int row = static_cast<int>(std::floor(v * rows));
    const double down = v * rows - row;
    // Every row starts elsewhere, by whole 1/16 so that the letters keep their texels.
    const double shifted = u + (latticeHash(row, 0, tile.seed) % 16u) / 16.0;
    const double x = (shifted - std::floor(shifted)) * kWordWidth;
    const double y = (down - 0.5 * (1.0 - kShare)) / kShare;

    const NearestLetter letter = nearestLetter(x, y);
    const double toBar = std::min(down, 1.0 - down) / kShare;
    const double raised =
        std::max(smoothStep(0.125, 0.04, letter.distance), 0.7 * smoothStep(0.07, 0.02, toBar));

    const int grainRows = tile.rows(24);
    const double grain = fractalNoise(u * 24.0, v * grainRows, 24, grainRows, 4, tile.seed + 9u);
    const double plate = 0.86 + 0.07 * grain;
    const double top = 0.07 + 0.012 * grain;
    return {std::clamp(std::lerp(plate, top, raised), 0.0, 1.0), raised,
            latticeHash(letter.number, row, tile.seed)};
}

}  // namespace relievo::textures
