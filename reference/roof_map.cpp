#include "reference/roof_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/ray_sector.h"
#include "textures/wrap_mode.h"

namespace relievo::reference {

namespace {

using textures::WrapMode;

// Where a cell is stored along one axis, and the direction in which that texel sees the ray.
struct StoredCell {
    int texel;
    double direction;
};

StoredCell storedCell(std::int64_t cell, int size, WrapMode wrap, double direction) {
    if (wrap != WrapMode::Mirror)
        return {textures::wrapIndex(cell, size, wrap), direction};
    const std::int64_t period = 2 * std::int64_t{size};
    const std::int64_t inPeriod = (cell % period + period) % period;
    if (inPeriod < size)
        return {static_cast<int>(inPeriod), direction};
    if (inPeriod == period - 1)
        return {0, std::abs(direction)};
    return {static_cast<int>(period - 2 - inPeriod), -direction};
}

double axisExit(double start, double speed, std::int64_t cell, int block) {
    if (speed == 0.0)
        return std::numeric_limits<double>::infinity();
    const std::int64_t border = speed > 0.0 ? cell + block + 1 : cell - block;
    return std::max((static_cast<double>(border) - start) / speed, 0.0);
}

}  // namespace

RoofCone roofConeAt(const RoofMap& roofs, const textures::DepthMap& relief, std::int64_t column,
                    std::int64_t row, const glm::dvec2& direction) {
    const StoredCell across = storedCell(column, relief.width(), relief.wrap, direction.x);
    const StoredCell down = storedCell(row, relief.height(), relief.wrap, direction.y);
    const int sector = raySector({across.direction, down.direction}, relief.aspect(),
                                 static_cast<int>(roofs.layers.size()));
    const RoofLayer& layer = roofs.layers[static_cast<std::size_t>(sector)];
    return {layer.roof.at(across.texel, down.texel), layer.ratio.at(across.texel, down.texel),
            across.texel, down.texel};
}

double blockExit(const glm::dvec2& start, const glm::dvec2& direction, std::int64_t column,
                 std::int64_t row, int block) {
    return std::min(axisExit(start.x, direction.x, column, block),
                    axisExit(start.y, direction.y, row, block));
}

}  // namespace relievo::reference
