#include "preprocess/view_displacement.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "preprocess/horizon_map.h"
#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

// The way of a line over the cells of one axis: which way it goes, and texels per tile width.
struct AxisWay {
    int sign;
    double speed;

    // Where it leaves the cell that lies after `passed` others. From integers every time.
    [[nodiscard]] double exit(int passed) const {
        return speed > 0.0 ? (passed + 1) / speed : kInfinity;
    }
};

AxisWay wayOf(double texels) {
    return {texels < 0.0 ? -1 : 1, std::abs(texels)};
}

struct LineWay {
    AxisWay across;
    AxisWay down;
};

LineWay lineOf(const DepthMap& map, double azimuth) {
    return {wayOf(std::cos(azimuth) * map.width()),
            wayOf(std::sin(azimuth) * map.width() / map.texelAspect)};
}

// The surface along a line in one cell, in tile widths: at the distance σ from `start` its depth is
// depth + slope·σ + bend·σ².
struct Piece {
    double start;
    double end;
    double depth;
    double slope;
    double bend;
};

// The surface from a texel's centre along a line. Pieces are made when they are asked for.
class Profile {
  public:
    Profile(const DepthMap& map, const LineWay& line, double depthScale)
        : map_(map), line_(line), depthScale_(depthScale) {}

    void begin(int i, int j) {
        pieces_.clear();
        column_ = i;
        row_ = j;
        columns_ = 0;
        rows_ = 0;
    }
    const Piece& piece(std::size_t index) {
        while (pieces_.size() <= index)
            addPiece();
        return pieces_[index];
    }

  private:
    // Cells are seen the way the line goes: corner 00 is the one it comes from, (0,0) to (1,1) lead
    // to corner 11.
    void addPiece() {
        const int i = column_ + line_.across.sign * columns_;
        const int j = row_ + line_.down.sign * rows_;
        const double d00 = map_.at(i, j);
        const double d10 = map_.at(i + line_.across.sign, j);
        const double d01 = map_.at(i, j + line_.down.sign);
        const double d11 = map_.at(i + line_.across.sign, j + line_.down.sign);
        const double twist = (d11 - d01) - (d10 - d00);
        const double start = pieces_.empty() ? 0.0 : pieces_.back().end;
        const double x = line_.across.speed * start - columns_;
        const double y = line_.down.speed * start - rows_;
        const double slopeX = (d10 - d00) + twist * y;
        const double slopeY = (d01 - d00) + twist * x;
        const double nextColumn = line_.across.exit(columns_);
        const double nextRow = line_.down.exit(rows_);
        pieces_.push_back({start, std::min(nextColumn, nextRow),
                           depthScale_ * (d00 + (d10 - d00) * x + slopeY * y),
                           depthScale_ * (slopeX * line_.across.speed + slopeY * line_.down.speed),
                           depthScale_ * twist * line_.across.speed * line_.down.speed});
        columns_ += nextColumn <= nextRow ? 1 : 0;
        rows_ += nextRow <= nextColumn ? 1 : 0;
    }

    const DepthMap& map_;
    LineWay line_;
    double depthScale_;
    std::vector<Piece> pieces_;
    int column_ = 0;
    int row_ = 0;
    int columns_ = 0;  // cells passed along each axis
    int rows_ = 0;
};

// The least σ ≥ 0 with constant + linear·σ + quadratic·σ² ≥ 0.
double firstNotNegative(double constant, double linear, double quadratic) {
    if (constant >= 0.0)
        return 0.0;
    const double discriminant = linear * linear - 4.0 * quadratic * constant;
    if (discriminant < 0.0)
        return kInfinity;
    // Of each sign of `linear` the form that does not cancel.
    const double root = std::sqrt(discriminant);
    if (linear >= 0.0)
        return linear + root > 0.0 ? -2.0 * constant / (linear + root) : kInfinity;
    return quadratic > 0.0 ? (root - linear) / (2.0 * quadratic) : kInfinity;
}

// A ray's depth at the horizontal distance s is tangent·s − curvature/2·s².
struct BentRay {
    double tangent;
    double curvature;
};

// Where a ray meets the surface, and in which piece; nowhere is after all pieces.
struct Hit {
    std::size_t piece = kNowhere;
    double s = kInfinity;
};

Hit findHit(Profile& profile, const BentRay& ray, std::size_t first) {
    if (first == kNowhere)
        return {};
    const double exit = ray.curvature > 0.0 ? 2.0 * ray.tangent / ray.curvature : kInfinity;
    for (std::size_t index = first;; ++index) {
        const Piece& piece = profile.piece(index);
        if (piece.start > exit)
            return {};
        const double bent = ray.curvature * piece.start;
        const double way =
            firstNotNegative((ray.tangent - bent / 2.0) * piece.start - piece.depth,
                             ray.tangent - bent - piece.slope, -ray.curvature / 2.0 - piece.bend);
        if (piece.start + way <= piece.end)
            return {index, piece.start + way};
    }
}

float storedDistance(double distance) {
    return roundDown(belowRounding(distance));
}

// The rays of one azimuth through one texel, which is number `texel`.
void traceTexel(Profile& profile, const ViewGrid& grid, int azimuth, std::size_t texel,
                std::vector<Plane>& table) {
    std::vector<std::size_t> starts(static_cast<std::size_t>(grid.curvatures), 0);
    for (int elevation = grid.elevations - 2; elevation >= 0; --elevation) {
        const double angle = grid.elevationOf(elevation);
        std::size_t start = 0;
        for (int curvature = 0; curvature < grid.curvatures; ++curvature) {
            std::size_t& steeper = starts[static_cast<std::size_t>(curvature)];
            const Hit hit = findHit(profile, {std::tan(angle), grid.curvatureOf(curvature)},
                                    std::max(start, steeper));
            steeper = hit.piece;
            start = hit.piece;
            table[grid.view(azimuth, elevation, curvature)].texels[texel] =
                hit.piece == kNowhere ? kNoHit : storedDistance(hit.s / std::cos(angle));
        }
    }
}

// Straight down, where neither the azimuth nor the curvature matters.
void fillVertical(const DepthMap& map, const ViewGrid& grid, std::vector<Plane>& table) {
    Plane depths = map.depth;
    for (float& depth : depths.texels)
        depth = storedDistance(grid.depthScale * static_cast<double>(depth));
    for (int curvature = 0; curvature < grid.curvatures; ++curvature)
        for (int azimuth = 0; azimuth < grid.azimuths; ++azimuth)
            table[grid.view(azimuth, grid.elevations - 1, curvature)] = depths;
}

}  // namespace

std::vector<Plane> buildViewDisplacement(const DepthMap& map, const ViewGrid& grid,
                                         const std::function<void(std::size_t)>& advance) {
    assert(grid.azimuths >= 1 && grid.elevations >= 1 && grid.curvatures % 2 == 1);
    assert(grid.depthScale > 0.0 && grid.sharpest >= 0.0);
    std::vector<Plane> table(grid.views(), Plane(map.width(), map.height()));
    fillVertical(map, grid, table);
    tbb::parallel_for(0, map.height(), [&](int j) {
        for (int azimuth = 0; azimuth < grid.azimuths; ++azimuth) {
            Profile profile(map, lineOf(map, azimuthOf(azimuth, grid.azimuths)), grid.depthScale);
            for (int i = 0; i < map.width(); ++i) {
                profile.begin(i, j);
                traceTexel(profile, grid, azimuth, map.depth.index(i, j), table);
            }
        }
        if (advance)
            advance(static_cast<std::size_t>(map.width()));
    });
    return table;
}

}  // namespace relievo::preprocess
