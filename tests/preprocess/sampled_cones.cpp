#include "tests/preprocess/sampled_cones.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace relievo::preprocess {
namespace {

using textures::DepthMap;

// In texel coordinates, so that the corners of cells are met exactly.
double depthAt(const DepthMap& map, double x, double y) {
    const auto i = static_cast<std::int64_t>(std::floor(x));
    const auto j = static_cast<std::int64_t>(std::floor(y));
    const double across = x - static_cast<double>(i);
    const double down = y - static_cast<double>(j);
    const auto row = [&](std::int64_t at) {
        return map.at(i, at) * (1.0 - across) + map.at(i + 1, at) * across;
    };
    return row(j) * (1.0 - down) + row(j + 1) * down;
}

// Whether the depth grows along (dx,dy) just after (x,y), in the cell that lies there.
bool growsAfter(const DepthMap& map, double x, double y, double dx, double dy, double tolerance) {
    const auto before = [](double at, double step) {
        const double first = std::floor(at);
        return static_cast<std::int64_t>(step < 0.0 && at == first ? first - 1.0 : first);
    };
    const std::int64_t i = before(x, dx);
    const std::int64_t j = before(y, dy);
    const double u = x - static_cast<double>(i);
    const double v = y - static_cast<double>(j);
    const double d0 = map.at(i, j);
    const double d1 = map.at(i + 1, j);
    const double d2 = map.at(i, j + 1);
    const double d3 = map.at(i + 1, j + 1);
    const double alongX = ((d1 - d0) * (1.0 - v) + (d3 - d2) * v) * dx;
    const double alongY = ((d2 - d0) * (1.0 - u) + (d3 - d1) * u) * dy;
    const double margin = tolerance * (std::abs(alongX) + std::abs(alongY));
    return alongX + alongY > margin || (margin == 0.0 && (d0 - d1 - d2 + d3) * dx * dy > 0.0);
}

}  // namespace

bool SampledSector::has(double dx, double dy) const {
    if (sectors == 1)
        return true;
    const double alongX = number % 2 == 0 ? dx : -dx;
    const double alongY = number / 2 % 2 == 0 ? dy : -dy;
    const double past = number < 4 ? alongX - alongY : alongY - alongX;
    return alongX >= 0.0 && alongY >= 0.0 && (sectors == 4 || past >= 0.0);
}

double steepestChord(const DepthMap& map, double x, double y, const SurfacePoints& points,
                     CrestTolerance crests, const SampledSector& sector) {
    const double depth = depthAt(map, x, y);
    const auto first = [&](double at) { return std::ceil(at / points.step) * points.step; };
    double steepest = 0.0;
    for (double toY = first(y - points.reachY); toY <= y + points.reachY; toY += points.step)
        for (double toX = first(x - points.reachX); toX <= x + points.reachX; toX += points.step) {
            const double length = std::hypot(toX - x, (toY - y) * map.texelAspect);
            const double rise = depth - depthAt(map, toX, toY);
            if (rise > steepest * length && rise > 0.0 &&
                sector.has(toX - x, (toY - y) * map.texelAspect) &&
                (!crests || growsAfter(map, toX, toY, toX - x, toY - y, *crests)))
                steepest = rise / length;
        }
    return steepest;
}

double ratioOfSlope(const DepthMap& map, double slope) {
    return slope > 0.0 ? 1.0 / (slope * map.width()) : std::numeric_limits<double>::infinity();
}

ConeSampling conservativeSampling(const DepthMap& map) {
    const double reach = std::max(map.width(), map.height());
    // Of repeated tiles no copy but the nearest can have a steeper chord.
    return {9, map.wrap == textures::WrapMode::Clamp ? reach : reach / 2.0, {}};
}

ConeSampling relaxedSampling(const DepthMap& map) {
    return {5, static_cast<double>(std::max(map.width(), map.height())), 1e-6};
}

double sampledRatio(const DepthMap& map, int i, int j, const ConeSampling& sampling) {
    double steepest = 0.0;
    const double last = sampling.apexes - 1;
    for (int b = 0; b <= last; ++b)
        for (int a = 0; a <= last; ++a) {
            const double x = i + a / last - 0.5;
            const double y = j + b / last - 0.5;
            steepest = std::max(
                {steepest,
                 steepestChord(map, x, y, {2.0, 2.0, 0.125}, sampling.crests, sampling.sector),
                 steepestChord(map, x, y, {sampling.reach, sampling.reach, 1.0}, sampling.crests,
                               sampling.sector)});
        }
    return ratioOfSlope(map, steepest);
}

Tightness compareWithSamples(const DepthMap& map, const textures::Plane& ratio,
                             const ConeSampling& sampling, int texels, unsigned seed) {
    std::mt19937 generator(seed);
    Tightness result;
    for (int k = 0; k < texels; ++k) {
        const int i = static_cast<int>(generator() % static_cast<unsigned>(map.width()));
        const int j = static_cast<int>(generator() % static_cast<unsigned>(map.height()));
        const double sampled = sampledRatio(map, i, j, sampling);
        result.tooWide += ratio.at(i, j) > sampled * (1.0 + 1e-9) ? 1 : 0;
        result.built += std::min(1.0, static_cast<double>(ratio.at(i, j)));
        result.sampled += std::min(1.0, sampled);
    }
    return result;
}

}  // namespace relievo::preprocess
