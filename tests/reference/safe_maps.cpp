#include "safe_maps.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <vector>

#include "reference/bilinear_cell.h"

namespace relievo::reference::test {

namespace {

using textures::DepthMap;
using textures::Plane;

// Least depths of the cells of a relief and of so many around it that every cell of a mirrored tile
// is there in every octant: up to one period along the axis that it follows less, and so as far
// again along the other one, up to its next multiple of the period.
struct CellsAround {
    int reach;
    int columns;
    std::vector<double> leastDepths;

    explicit CellsAround(const DepthMap& relief)
        : reach(2 * (relief.width() + relief.height()) + 2), columns(relief.width() + 2 * reach) {
        for (int j = -reach; j < relief.height() + reach; ++j)
            for (int i = -reach; i < relief.width() + reach; ++i)
                leastDepths.push_back(std::min({relief.at(i, j), relief.at(i + 1, j),
                                                relief.at(i, j + 1), relief.at(i + 1, j + 1)}));
    }
    [[nodiscard]] double least(int i, int j) const {
        return leastDepths[static_cast<std::size_t>((j + reach) * columns + i + reach)];
    }
};

float roundedDown(double value) {
    if (std::isinf(value))
        return std::numeric_limits<float>::infinity();
    return std::nextafter(static_cast<float>(value * (1.0 - 1e-12)), 0.0f);
}

// Offsets of cells as a ray of one sector sees them: forward along both axes.
class Sector {
  public:
    Sector(int index, int layers, int block, double texelAspect)
        : layers_(layers), block_(block), texelAspect_(texelAspect) {
        across_ = index % 2 == 0 ? 1 : -1;
        down_ = index / 2 % 2 == 0 ? 1 : -1;
        isSteep_ = index >= 4;
    }
    [[nodiscard]] int block() const { return block_; }
    [[nodiscard]] bool holdsInBlock(int x, int y) const {
        return layers_ == 1 ? std::max(std::abs(x), std::abs(y)) <= block_
                            : forward(x, across_, block_) && forward(y, down_, block_);
    }
    [[nodiscard]] bool reaches(int x, int y) const {
        if (layers_ == 1)
            return true;
        if (x * across_ < 0 || y * down_ < 0)
            return false;
        if (layers_ == 4)
            return true;
        // From one corner of the cell to the other's opposite one, no steeper than the sector.
        const int lower = isSteep_ ? std::abs(x) : std::abs(y);
        const int upper = isSteep_ ? std::abs(y) : std::abs(x);
        const double lowerTexel = isSteep_ ? 1.0 : texelAspect_;
        const double upperTexel = isSteep_ ? texelAspect_ : 1.0;
        return std::max(lower - 1, 0) * lowerTexel <= (upper + 1) * upperTexel;
    }

  private:
    static bool forward(int offset, int sign, int block) {
        return offset * sign >= 0 && offset * sign <= block;
    }
    int layers_;
    int block_;
    double texelAspect_;
    int across_ = 1;
    int down_ = 1;
    bool isSteep_ = false;
};

void buildCell(const DepthMap& relief, const CellsAround& cells, const Sector& sector, int i, int j,
               RoofLayer& layer) {
    double roof = 1.0;
    for (int y = -sector.block(); y <= sector.block(); ++y)
        for (int x = -sector.block(); x <= sector.block(); ++x)
            if (sector.holdsInBlock(x, y))
                roof = std::min(roof, cells.least(i + x, j + y));
    double ratio = std::numeric_limits<double>::infinity();
    for (int y = -cells.reach; y <= cells.reach; ++y)
        for (int x = -cells.reach; x <= cells.reach; ++x) {
            const double least = cells.least(i + x, j + y);
            if (least >= roof || sector.holdsInBlock(x, y) || !sector.reaches(x, y))
                continue;
            const double distance = std::hypot(std::max(std::abs(x) - 1, 0),
                                               relief.texelAspect * std::max(std::abs(y) - 1, 0));
            ratio = std::min(ratio, distance / relief.width() / (roof - least));
        }
    layer.roof.at(i, j) = static_cast<float>(roof);
    layer.ratio.at(i, j) = roundedDown(ratio);
}

}  // namespace

DepthMap noiseRelief(int width, int height, textures::WrapMode wrap, std::uint32_t seed,
                     bool isBinary) {
    std::mt19937 random(seed);
    DepthMap relief{Plane(width, height), wrap};
    for (float& depth : relief.depth.texels) {
        depth = static_cast<float>(static_cast<double>(random()) / 4294967296.0);
        if (isBinary)
            depth = std::round(depth);
    }
    return relief;
}

// |∇D| is convex in a cell, so it is greatest at a corner.
Plane slopeCones(const DepthMap& relief, double factor) {
    double steepest = 0.0;
    for (int j = -1; j < relief.height(); ++j)
        for (int i = -1; i < relief.width(); ++i) {
            const BilinearCell cell(relief.at(i, j), relief.at(i + 1, j), relief.at(i, j + 1),
                                    relief.at(i + 1, j + 1));
            for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}})
                steepest = std::max(steepest, glm::length(cell.gradient(corner) /
                                                          glm::dvec2(1.0, relief.texelAspect)));
        }
    const double ratio = factor * 0.999999 / (steepest * relief.width());
    return {relief.width(), relief.height(), static_cast<float>(ratio)};
}

RoofMap bruteForceRoofs(const DepthMap& relief, int layers, int block) {
    RoofMap roofs;
    roofs.block = block;
    const CellsAround cells(relief);
    for (int index = 0; index < layers; ++index) {
        const Sector sector(index, layers, block, relief.texelAspect);
        RoofLayer layer{Plane(relief.width(), relief.height()),
                        Plane(relief.width(), relief.height())};
        // The first cells of a clamped or mirrored map serve the cell before them as well, from
        // which an octant reaches more: there it is taken for a quadrant.
        const Sector atBorder(index, layers == 8 ? 4 : layers, block, relief.texelAspect);
        const bool sharesBorder = relief.wrap != textures::WrapMode::Repeat;
        for (int j = 0; j < relief.height(); ++j)
            for (int i = 0; i < relief.width(); ++i)
                buildCell(relief, cells, sharesBorder && (i == 0 || j == 0) ? atBorder : sector, i,
                          j, layer);
        roofs.layers.push_back(std::move(layer));
    }
    return roofs;
}

}  // namespace relievo::reference::test
