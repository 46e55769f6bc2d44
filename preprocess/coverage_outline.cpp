#include "preprocess/coverage_outline.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <optional>

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::WrapMode;

constexpr double kHalf = 0.5;
constexpr int kReach = 6;              // texels in which a sum must find its ends
constexpr float kFull = 127.0f / 128;  // of a texel: rounding of 8 bits does not count
constexpr float kEmpty = 1.0f / 128;
constexpr double kBeyond = 0.02;  // texels that a sum may miss its pair of centres by

// Sides of a cell, which lies between four texel centres: (i,j) is the upper left one.
enum Side { kTop, kRight, kBottom, kLeft };

constexpr Side opposite(Side side) {
    return static_cast<Side>((side + 2) % 4);
}

struct Cell {
    int i;
    int j;
};

constexpr Cell beyond(Cell cell, Side side) {
    constexpr std::array<int, 4> kColumn{0, 1, 0, -1};
    constexpr std::array<int, 4> kRow{-1, 0, 1, 0};
    return {cell.i + kColumn[side], cell.j + kRow[side]};
}

// Where a chain comes into a cell.
struct Step {
    Cell cell;
    Side side;
};

class Tracer {
  public:
    Tracer(const Plane& coverage, const TexelSides& sides)
        : coverage_(coverage),
          sides_(sides),
          wrap_(sides.wrap),
          repeats_(sides.wrap == WrapMode::Repeat),
          columns_(coverage.width + (repeats_ ? 0 : 1)),
          rows_(coverage.height + (repeats_ ? 0 : 1)),
          first_(repeats_ ? 0 : -1),
          visited_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

    std::vector<OutlineChain> trace() {
        if (!repeats_)
            traceFromBorders();
        for (const std::vector<Cell>& cells : unevenCells())
            for (const Cell& cell : cells)
                traceFrom(cell);
        std::vector<OutlineChain> chains(ways_.size());
        tbb::parallel_for(std::size_t{0}, chains.size(),
                          [&](std::size_t k) { chains[k] = chainOf(ways_[k]); });
        return chains;
    }

  private:
    [[nodiscard]] float at(int i, int j) const {
        return coverage_.at(textures::wrapIndex(i, coverage_.width, wrap_),
                            textures::wrapIndex(j, coverage_.height, wrap_));
    }
    [[nodiscard]] bool isInside(int i, int j) const { return sides_.isInside(i, j); }

    // Corners clockwise from the upper left one: a side lies between two that follow each other.
    [[nodiscard]] std::array<bool, 4> corners(Cell cell) const {
        return {isInside(cell.i, cell.j), isInside(cell.i + 1, cell.j),
                isInside(cell.i + 1, cell.j + 1), isInside(cell.i, cell.j + 1)};
    }

    // Whether the chain that crosses `side` comes in there: with the inside to its right.
    static bool isEntry(const std::array<bool, 4>& inside, int side) {
        return inside[static_cast<std::size_t>(side)] &&
               !inside[static_cast<std::size_t>((side + 1) % 4)];
    }
    static bool isExit(const std::array<bool, 4>& inside, int side) {
        return !inside[static_cast<std::size_t>(side)] &&
               inside[static_cast<std::size_t>((side + 1) % 4)];
    }

    // Whether the insides of a cell with two opposite corners inside are joined: the sign of the
    // bilinear interpolation at its saddle.
    [[nodiscard]] bool isJoined(Cell cell) const {
        const double a = at(cell.i, cell.j) - kHalf;
        const double b = at(cell.i + 1, cell.j) - kHalf;
        const double c = at(cell.i + 1, cell.j + 1) - kHalf;
        const double d = at(cell.i, cell.j + 1) - kHalf;
        const double slope = a + c - b - d;
        const double numerator = a * c - b * d;
        return slope > 0.0 ? numerator >= 0.0 : numerator <= 0.0;
    }

    [[nodiscard]] Side exitFrom(Cell cell, Side entry) const {
        const std::array<bool, 4> inside = corners(cell);
        const bool isSaddle = inside[0] == inside[2] && inside[1] == inside[3];
        if (!isSaddle) {
            for (const Side side : {kTop, kRight, kBottom, kLeft})
                if (isExit(inside, side))
                    return side;
        }
        // Around the corner outside when the insides are joined: it is behind the entry, clockwise.
        return static_cast<Side>((entry + (isJoined(cell) ? 1 : 3)) % 4);
    }

    // The place on the line of centres on which `at` is the coverage: it is inside at `index` and
    // outside at index + step.
    template <typename At>
    static OutlinePoint crossing(const At& at, int index, int step, int axis,
                                 const glm::dvec2& line) {
        const double in = at(index);
        const double out = at(index + step);
        OutlinePoint point{line, false};
        point.place[axis] = index + 0.5 + step * (in - kHalf) / (in - out);
        const std::optional<double> sum = summed(at, index, step);
        if (!sum)
            return point;
        const double along = (*sum - (index + 0.5)) * step;  // 0 to 1 between the centres
        if (along < -kBeyond || along > 1.0 + kBeyond)
            return point;
        point.place[axis] = index + 0.5 + step * std::clamp(along, 0.0, 1.0);
        point.isSure = true;
        return point;
    }

    template <typename At>
    static std::optional<double> summed(const At& at, int index, int step) {
        double sum = 0.0;
        int full = index;
        float last = 0.0f;
        for (int k = 0; at(full) < kFull; ++k, full -= step) {
            if (k == kReach || at(full) < last)
                return std::nullopt;
            last = at(full);
            sum += last;
        }
        int empty = index + step;
        last = 1.0f;
        for (int k = 0; at(empty) > kEmpty; ++k, empty += step) {
            if (k == kReach || at(empty) > last)
                return std::nullopt;
            last = at(empty);
            sum += last;
        }
        // The side of the full texel that faces the empty one.
        return full + (step > 0 ? 1.0 : 0.0) + step * sum;
    }

    // The point on a side of a cell that the chain crosses.
    [[nodiscard]] OutlinePoint pointOn(Cell cell, Side side) const {
        const bool isLevel = side == kTop || side == kBottom;
        const int i = cell.i + (side == kRight ? 1 : 0);
        const int j = cell.j + (side == kBottom ? 1 : 0);
        OutlinePoint point;
        const int step = isInside(i, j) ? 1 : -1;
        if (isLevel)
            point = crossing([&](int k) { return at(k, j); }, step > 0 ? i : i + 1, step, 0,
                             {0.0, j + 0.5});
        else
            point = crossing([&](int k) { return at(i, k); }, step > 0 ? j : j + 1, step, 1,
                             {i + 0.5, 0.0});
        if (!repeats_)  // half cells around the tile end at its border
            point.place = glm::clamp(point.place, glm::dvec2(0.0),
                                     glm::dvec2(coverage_.width, coverage_.height));
        return point;
    }

    [[nodiscard]] bool isInGrid(Cell cell) const {
        return repeats_ || (cell.i >= first_ && cell.i < first_ + columns_ && cell.j >= first_ &&
                            cell.j < first_ + rows_);
    }
    [[nodiscard]] std::uint8_t& visitsOf(Cell cell) {
        const int i =
            repeats_ ? textures::wrapIndex(cell.i, columns_, WrapMode::Repeat) : cell.i - first_;
        const int j =
            repeats_ ? textures::wrapIndex(cell.j, rows_, WrapMode::Repeat) : cell.j - first_;
        return visited_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
                        static_cast<std::size_t>(i)];
    }

    // The cells with corners on both sides, row by row, in bands of rows.
    [[nodiscard]] std::vector<std::vector<Cell>> unevenCells() const {
        constexpr int kBandRows = 32;
        std::vector<std::vector<Cell>> bands(
            static_cast<std::size_t>((rows_ + kBandRows - 1) / kBandRows));
        tbb::parallel_for(std::size_t{0}, bands.size(), [&](std::size_t band) {
            const int top = first_ + static_cast<int>(band) * kBandRows;
            std::vector<std::uint8_t> isUneven(static_cast<std::size_t>(coverage_.width));
            for (int j = top; j < std::min(top + kBandRows, first_ + rows_); ++j)
                appendUneven(j, isUneven, bands[band]);
        });
        return bands;
    }

    // Those of a row. Nearly all within the tile are even, and looked at many at a time.
    void appendUneven(int j, std::vector<std::uint8_t>& isUneven, std::vector<Cell>& cells) const {
        const int width = coverage_.width;
        const auto append = [&](int i) {
            const std::array<bool, 4> inside = corners({i, j});
            if (inside[0] != inside[1] || inside[0] != inside[2] || inside[0] != inside[3])
                cells.push_back({i, j});
        };
        const std::uint8_t* const upper =
            &sides_.inside[coverage_.index(0, textures::wrapIndex(j, coverage_.height, wrap_))];
        const std::uint8_t* const lower =
            &sides_.inside[coverage_.index(0, textures::wrapIndex(j + 1, coverage_.height, wrap_))];
        for (int i = 0; i + 1 < width; ++i)
            isUneven[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(
                (upper[i] ^ upper[i + 1]) | (upper[i] ^ lower[i]) | (upper[i] ^ lower[i + 1]));
        if (first_ < 0)
            append(-1);
        const auto end = isUneven.begin() + (width - 1);
        for (auto next = std::find(isUneven.begin(), end, 1); next != end;
             next = std::find(next + 1, end, 1))
            cells.push_back({static_cast<int>(next - isUneven.begin()), j});
        append(width - 1);
    }

    void traceFrom(Cell cell) {
        const std::array<bool, 4> inside = corners(cell);
        for (const Side side : {kTop, kRight, kBottom, kLeft})
            if (isEntry(inside, side) && (visitsOf(cell) & (1 << side)) == 0)
                follow(cell, side);
    }

    void traceFromBorders() {
        const auto enter = [&](Cell cell, Side side) {
            if (isEntry(corners(cell), side))
                follow(cell, side);
        };
        for (int i = first_; i < first_ + columns_; ++i) {
            enter({i, first_}, kTop);
            enter({i, first_ + rows_ - 1}, kBottom);
        }
        for (int j = first_; j < first_ + rows_; ++j) {
            enter({first_, j}, kLeft);
            enter({first_ + columns_ - 1, j}, kRight);
        }
    }

    // The chain that comes into `start` by `entry`: until it leaves the grid, or comes there again.
    void follow(const Cell start, const Side entry) {
        std::vector<Step>& way = ways_.emplace_back();
        Step step{start, entry};
        while (true) {
            way.push_back(step);
            if (!isInGrid(step.cell))
                return;
            std::uint8_t& visits = visitsOf(step.cell);
            if ((visits & (1 << step.side)) != 0)
                return;
            visits = static_cast<std::uint8_t>(visits | (1 << step.side));
            const Side exit = exitFrom(step.cell, step.side);
            step = {beyond(step.cell, exit), opposite(exit)};
        }
    }

    [[nodiscard]] OutlineChain chainOf(const std::vector<Step>& way) const {
        constexpr std::size_t kPointsAtOnce = 1024;
        OutlineChain chain;
        chain.points.resize(way.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, way.size(), kPointsAtOnce),
                          [&](const tbb::blocked_range<std::size_t>& steps) {
                              for (std::size_t k = steps.begin(); k < steps.end(); ++k)
                                  chain.points[k] = pointOn(way[k].cell, way[k].side);
                          });
        chain.isClosed = isInGrid(way.back().cell);
        if (chain.isClosed) {
            chain.period = chain.points.back().place - chain.points.front().place;
            chain.points.pop_back();
        }
        return chain;
    }

    const Plane& coverage_;
    const TexelSides& sides_;
    WrapMode wrap_;
    bool repeats_;
    int columns_;  // of the grid of cells
    int rows_;
    int first_;                          // cell of it
    std::vector<std::uint8_t> visited_;  // a bit for each side by which a chain came in
    std::vector<std::vector<Step>> ways_;
};

}  // namespace

std::vector<OutlineChain> traceCoverage(const Plane& coverage, const TexelSides& sides) {
    return Tracer(coverage, sides).trace();
}

}  // namespace relievo::preprocess
