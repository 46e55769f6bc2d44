#include "textures/sample_terrain.h"

#include <numbers>

#include "textures/lattice_noise.h"
#include "textures/sample_reliefs.h"

namespace relievo::textures {

namespace {
constexpr double kTwoPi = 2.0 * std::numbers::pi;
}

SampleSurface noiseSurface(double u, double v, const SampleTile& tile) {
    constexpr int kColumns = 4;
    const int rows = tile.rows(kColumns);
    const double height = fractalNoise(u * kColumns, v * rows, kColumns, rows, 7, tile.seed);
    const double depth = std::clamp(0.5 - 0.42 * height, 0.0, 1.0);
    return {depth, 1.0 - depth, 0};
}

SampleSurface ridgeSurface(double u, double v, const SampleTile&) {
    const double bend = 0.08 * std::sin(kTwoPi * u);
    const double section = 0.5 - 0.5 * std::cos(kTwoPi * (v + bend));
    const double crest = 0.62 - 0.33 * std::cos(kTwoPi * u);
    const double height = crest * section * section * section;
    return {1.0 - height, height, 0};
}

SampleSurface waveSurface(double u, double v, const SampleTile&) {
    const double depth = waveDepth(u, v);
    return {depth, 1.0 - depth, 0};
}

double waveDepth(double u, double v) {
    return 0.5 + 0.24 * std::sin(kTwoPi * (u + 2.0 * v)) + 0.24 * std::cos(kTwoPi * (2.0 * u - v));
}

}  // namespace relievo::textures
