#include "preprocess/cylinder_radii.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr float kNoRow = std::numeric_limits<float>::infinity();

// The signs of the directions of a quadrant.
struct Quadrant {
    int x;
    int y;
    std::uint8_t bit;
};
constexpr Quadrant kQuadrants[] = {{1, 1, 1}, {-1, 1, 2}, {1, -1, 4}, {-1, -1, 8}};

// Whether the depths bend down at texel (i,j), along u for (1,0) and along v for (0,1).
bool bendsDown(const DepthMap& map, int i, int j, int alongU, int alongV) {
    const double before = map.at(i - alongU, j - alongV);
    const double behind = map.at(i + alongU, j + alongV);
    return before + behind > 2.0 * map.at(i, j);
}

// The quadrants in whose directions the depth may begin to grow faster in the cell between the
// texels (i,j) and (i+1,j+1), or on entering it.
std::uint8_t marksOf(const DepthMap& map, int i, int j) {
    const double d00 = map.at(i, j);
    const double d10 = map.at(i + 1, j);
    const double d01 = map.at(i, j + 1);
    const double d11 = map.at(i + 1, j + 1);
    std::uint8_t marks = 0;
    for (const Quadrant& quadrant : kQuadrants) {
        const bool grows = std::max(quadrant.x * (d10 - d00), quadrant.x * (d11 - d01)) > 0.0 ||
                           std::max(quadrant.y * (d01 - d00), quadrant.y * (d11 - d10)) > 0.0;
        if (!grows)
            continue;
        const int column = quadrant.x > 0 ? i : i + 1;  // of the sides by which rays enter
        const int row = quadrant.y > 0 ? j : j + 1;
        if (quadrant.x * quadrant.y * (d00 - d10 - d01 + d11) > 0.0 ||
            bendsDown(map, column, j, 1, 0) || bendsDown(map, column, j + 1, 1, 0) ||
            bendsDown(map, i, row, 0, 1) || bendsDown(map, i + 1, row, 0, 1))
            marks |= quadrant.bit;
    }
    return marks;
}

// Cell k along an axis lies between texels k and k+1. A period of cells, or all that are not flat
// where the map is clamped.
struct Cells {
    int first;
    int count;
    bool repeat;

    [[nodiscard]] int period() const { return repeat ? count : 0; }
    [[nodiscard]] int slot(int k) const {
        return repeat ? wrapIndex(k, count, WrapMode::Repeat) : k - first;
    }
};

Cells cellsOf(int size, WrapMode wrap) {
    switch (wrap) {
        case WrapMode::Repeat:
            return {0, size, true};
        case WrapMode::Mirror:
            return {0, 2 * size, true};
        case WrapMode::Clamp:
            break;
    }
    return {-1, size + 1, false};
}

struct CellMarks {
    Cells columns;
    Cells rows;
    std::vector<std::uint8_t> marks;

    [[nodiscard]] const std::uint8_t* row(int l) const {
        return marks.data() +
               static_cast<std::size_t>(rows.slot(l)) * static_cast<std::size_t>(columns.count);
    }
};

CellMarks markCells(const DepthMap& map) {
    CellMarks cells{cellsOf(map.width(), map.wrap), cellsOf(map.height(), map.wrap), {}};
    const auto pitch = static_cast<std::size_t>(cells.columns.count);
    cells.marks.resize(pitch * static_cast<std::size_t>(cells.rows.count));
    tbb::parallel_for(0, cells.rows.count, [&](int l) {
        for (int k = 0; k < cells.columns.count; ++k)
            cells.marks[static_cast<std::size_t>(l) * pitch + static_cast<std::size_t>(k)] =
                marksOf(map, cells.columns.first + k, cells.rows.first + l);
    });
    return cells;
}

// For each row of texels and column of cells the distance in texels, along the column and the way
// of the quadrant, from the squares of the row to the nearest marked cell; 0 for cells that the
// squares touch.
Plane measureColumns(const CellMarks& cells, const Quadrant& quadrant, int height) {
    Plane gaps(cells.columns.count, height);
    const int ahead = cells.rows.period();
    const auto scan = [&](const tbb::blocked_range<int>& columns) {
        std::vector<float> nearest(static_cast<std::size_t>(columns.size()), kNoRow);
        // From far to near. Squares of row j touch the cells j−1 and j: the last one that counts
        // is the one behind their centres.
        for (int n = height - 1 + ahead; n >= -1; --n) {
            const int l = quadrant.y > 0 ? n : height - 2 - n;
            const int j = quadrant.y > 0 ? l + 1 : l;
            const std::uint8_t* const marks = cells.row(l);
            for (int k = columns.begin(); k < columns.end(); ++k) {
                float& gap = nearest[static_cast<std::size_t>(k - columns.begin())];
                // Counted in whole cells from the one behind the centre.
                gap = (marks[k] & quadrant.bit) != 0 ? 0.0f : gap + 1.0f;
                if (j >= 0 && j < height)
                    gaps.at(k, j) = std::max(0.0f, gap - 1.5f);
            }
        }
    };
    tbb::parallel_for(tbb::blocked_range<int>(0, cells.columns.count, 64), scan);
    return gaps;
}

// The lower envelope of parabolas height + (x − place)², of which more come at ever lower places
// and which is asked for at ever lower x, before all of their places. A newer one, once it is the
// lower one, remains so.
class OneSidedEnvelope {
  public:
    void clear() {
        parabolas_.clear();
        first_ = 0;
    }
    void add(double place, double height) {
        const Parabola next{place, height};
        while (parabolas_.size() > first_ + 1 &&
               takeover(parabolas_.back(), next) >=
                   takeover(parabolas_[parabolas_.size() - 2], parabolas_.back()))
            parabolas_.pop_back();
        parabolas_.push_back(next);
    }
    double at(double x) {
        if (parabolas_.empty())
            return kNone;
        while (first_ + 1 < parabolas_.size() &&
               takeover(parabolas_[first_], parabolas_[first_ + 1]) >= x)
            ++first_;
        const double across = parabolas_[first_].place - x;
        return parabolas_[first_].height + across * across;
    }

  private:
    struct Parabola {
        double place;
        double height;
    };
    // From where on, towards lower x, the newer one is the lower one.
    static double takeover(const Parabola& older, const Parabola& newer) {
        return (older.place + newer.place +
                (older.height - newer.height) / (older.place - newer.place)) /
               2;
    }

    std::vector<Parabola> parabolas_;
    std::size_t first_ = 0;
};

// A row of texels: lowers squared distances to those of one quadrant. Looking the other way is the
// same with cell k at the place of −1 − k and texel i at −i.
void measureRow(const float* gaps, const Cells& cells, int sign, double aspect, int width,
                OneSidedEnvelope& envelope, std::vector<double>& squared) {
    const auto height = [&](int k) {
        const int cell = sign > 0 ? k : -1 - k;
        const double gap =
            aspect * (cells.repeat || (cell >= cells.first && cell < cells.first + cells.count)
                          ? gaps[cells.slot(cell)]
                          : kNoRow);
        return gap * gap;
    };
    const int high = sign > 0 ? width - 1 : 0;
    const int low = high - (width - 1);
    envelope.clear();
    const auto add = [&](int k) {
        if (const double value = height(k); value < kNone)
            envelope.add(k, value);
    };
    for (int k = high + cells.period(); k > high; --k)
        add(k);
    for (int i = high; i >= low; --i) {
        double& least = squared[static_cast<std::size_t>(sign > 0 ? i : -i)];
        least = std::min({least, envelope.at(i + 0.5), height(i), height(i - 1)});
        add(i);
    }
}

// The radius, in tile widths, of a squared distance in texels, less what rounding may have added.
float radiusOf(double squared, double span, int width) {
    if (squared == kNone)
        return std::numeric_limits<float>::infinity();
    const double rounding = 32.0 * std::numeric_limits<double>::epsilon() * span * span;
    return roundDown(belowRounding(std::sqrt(std::max(0.0, squared - rounding))) / width);
}

}  // namespace

Plane buildCylinderRadii(const DepthMap& map) {
    const CellMarks cells = markCells(map);
    Plane radii(map.width(), map.height(), std::numeric_limits<float>::infinity());
    const double span =
        map.width() + cells.columns.count + map.texelAspect * (map.height() + cells.rows.count);
    for (const Quadrant& quadrant : kQuadrants) {
        const Plane columns = measureColumns(cells, quadrant, map.height());
        tbb::parallel_for(tbb::blocked_range<int>(0, map.height(), 16), [&](const auto& rows) {
            OneSidedEnvelope envelope;
            std::vector<double> squared(static_cast<std::size_t>(map.width()));
            for (int j = rows.begin(); j < rows.end(); ++j) {
                std::fill(squared.begin(), squared.end(), kNone);
                measureRow(&columns.texels[columns.index(0, j)], cells.columns, quadrant.x,
                           map.texelAspect, map.width(), envelope, squared);
                for (int i = 0; i < map.width(); ++i)
                    radii.at(i, j) =
                        std::min(radii.at(i, j),
                                 radiusOf(squared[static_cast<std::size_t>(i)], span, map.width()));
            }
        });
    }
    return radii;
}

}  // namespace relievo::preprocess
