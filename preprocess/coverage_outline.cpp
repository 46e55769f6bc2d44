#include "preprocess/coverage_outline.h"

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

class Tracer {
  public:
    Tracer(const Plane& coverage, WrapMode wrap)
        : coverage_(coverage),
          wrap_(wrap),
          repeats_(wrap == WrapMode::Repeat),
          columns_(coverage.width + (repeats_ ? 0 : 1)),
          rows_(coverage.height + (repeats_ ? 0 : 1)),
          first_(repeats_ ? 0 : -1),
          visited_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

    std::vector<OutlineChain> trace() {
        if (!repeats_)
            traceFromBorders();
        for (int j = first_; j < first_ + rows_; ++j)
            traceFromRow(j);
        return std::move(chains_);
    }

  private:
    [[nodiscard]] float at(int i, int j) const {
        return coverage_.at(textures::wrapIndex(i, coverage_.width, wrap_),
                            textures::wrapIndex(j, coverage_.height, wrap_));
    }
    [[nodiscard]] bool isInside(int i, int j) const { return at(i, j) >= kHalf; }

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

    // Most cells have all corners inside or all outside: those within the tile are looked at many
    // at a time.
    void traceFromRow(int j) {
        const int width = coverage_.width;
        if (j < 0 || j + 1 >= coverage_.height) {
            for (int i = first_; i < first_ + columns_; ++i)
                traceFrom({i, j});
            return;
        }
        const float* const upper = &coverage_.texels[coverage_.index(0, j)];
        const float* const lower = upper + width;
        isUneven_.resize(static_cast<std::size_t>(width));
        for (int i = 0; i + 1 < width; ++i) {
            const int inside = (upper[i] >= 0.5f) + (upper[i + 1] >= 0.5f) + (lower[i] >= 0.5f) +
                               (lower[i + 1] >= 0.5f);
            isUneven_[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(inside & 3);
        }
        if (first_ < 0)
            traceFrom({-1, j});
        for (int i = 0; i + 1 < width; ++i)
            if (isUneven_[static_cast<std::size_t>(i)] != 0)
                traceFrom({i, j});
        traceFrom({width - 1, j});
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

    // The chain that comes into `start` by `entry`.
    void follow(const Cell start, const Side entry) {
        OutlineChain& chain = chains_.emplace_back();
        Cell cell = start;
        Side side = entry;
        while (true) {
            chain.points.push_back(pointOn(cell, side));
            if (!isInGrid(cell)) {
                chain.isClosed = false;
                return;
            }
            std::uint8_t& visits = visitsOf(cell);
            if ((visits & (1 << side)) != 0)
                break;
            visits = static_cast<std::uint8_t>(visits | (1 << side));
            const Side exit = exitFrom(cell, side);
            cell = beyond(cell, exit);
            side = opposite(exit);
        }
        chain.period = chain.points.back().place - chain.points.front().place;
        chain.points.pop_back();
    }

    const Plane& coverage_;
    WrapMode wrap_;
    bool repeats_;
    int columns_;  // of the grid of cells
    int rows_;
    int first_;                           // cell of it
    std::vector<std::uint8_t> isUneven_;  // cells of a row: not 0
    std::vector<std::uint8_t> visited_;   // a bit for each side by which a chain came in
    std::vector<OutlineChain> chains_;
};

}  // namespace

std::vector<OutlineChain> traceCoverage(const Plane& coverage, WrapMode wrap) {
    return Tracer(coverage, wrap).trace();
}

}  // namespace relievo::preprocess
