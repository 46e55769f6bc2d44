#include "preprocess/horizon_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "textures/bilinear.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;

// Places that are nearer to each other than this part of a texel are one.
constexpr double kSame = 1e-9;

// How lines of one azimuth run over a map. Their places are whole on one axis, the major one.
struct Direction {
    bool alongRows;  // the major axis is that of u
    int ahead;       // 1 or −1: the way along the major axis
    double slope;    // texels along the minor axis for each along the major one, −1 to 1
    double length;   // texel widths for each texel along the major axis
};

Direction directionOf(const DepthMap& map, double azimuth) {
    const double x = std::cos(azimuth);
    const double y = std::sin(azimuth) / map.texelAspect;
    const bool isDiagonal = std::abs(std::abs(x) - std::abs(y)) < kSame * std::abs(x);
    const bool alongRows = isDiagonal ? map.width() >= map.height() : std::abs(x) > std::abs(y);
    const double major = alongRows ? x : y;
    double slope = (alongRows ? y : x) / major;
    if (isDiagonal || std::abs(slope) < kSame)
        slope = std::nearbyint(slope);
    return {alongRows, major > 0.0 ? 1 : -1, slope, 1.0 / std::abs(major)};
}

// The lines of one azimuth: line n passes the place (x, n + slope·x).
class Lines {
  public:
    Lines(const DepthMap& map, const Direction& direction)
        : map_(map),
          direction_(direction),
          columns_(direction.alongRows ? map.width() : map.height()),
          rows_(direction.alongRows ? map.height() : map.width()) {}

    [[nodiscard]] const Direction& direction() const { return direction_; }
    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] bool repeat() const { return map_.wrap != WrapMode::Clamp; }
    // Texels after which the map repeats, along the major axis. A clamped one is not followed
    // farther than that either.
    [[nodiscard]] int reach() const {
        return map_.wrap == WrapMode::Mirror ? 2 * columns_ : columns_;
    }
    // As many lines as there are different ones, or that pass one column.
    [[nodiscard]] int period() const {
        switch (map_.wrap) {
            case WrapMode::Repeat:
                return rows_;
            case WrapMode::Mirror:
                return 2 * rows_;
            case WrapMode::Clamp:
                break;
        }
        return rows_ + 2;
    }
    [[nodiscard]] int first() const {
        return repeat() ? 0 : static_cast<int>(std::floor(std::min(0.0, drift()))) - 1;
    }
    [[nodiscard]] int end() const {
        return repeat() ? period()
                        : rows_ + static_cast<int>(std::ceil(std::max(0.0, drift()))) + 1;
    }
    [[nodiscard]] double row(int n, double x) const { return n + direction_.slope * x; }
    // Whether some texel of column x takes values of line n.
    [[nodiscard]] bool isNeeded(int n, int x) const {
        return repeat() || (row(n, x) > -1.0 && row(n, x) < rows_);
    }
    [[nodiscard]] double depth(int n, double x) const {
        const double y = row(n, x);
        const double u = ((direction_.alongRows ? x : y) + 0.5) / map_.width();
        const double v = ((direction_.alongRows ? y : x) + 0.5) / map_.height();
        return sampleBilinear(map_.depth, u, v, map_.wrap);
    }
    // Where `values` holds line n.
    [[nodiscard]] int slot(int n) const { return wrapIndex(n, period(), WrapMode::Repeat); }

  private:
    // The numbers of the line through a texel of the last column, less its row.
    [[nodiscard]] double drift() const { return -direction_.slope * (columns_ - 1); }

    const DepthMap& map_;
    Direction direction_;
    int columns_;
    int rows_;
};

// The convex hull of what lies ahead of a place on a line.
class Hull {
  public:
    void clear() { points_.clear(); }
    // The greatest slope from the point, which must lie before all others, to one of them; and adds
    // it.
    double add(double place, double depth) {
        const auto slopeTo = [&](const Point& point) {
            return (depth - point.depth) / (point.place - place);
        };
        while (points_.size() > 1 &&
               slopeTo(points_.back()) <= slopeTo(points_[points_.size() - 2]))
            points_.pop_back();
        const double slope = points_.empty() ? 0.0 : slopeTo(points_.back());
        points_.push_back({place, depth});
        return slope;
    }

  private:
    struct Point {
        double place;
        double depth;
    };
    std::vector<Point> points_;
};

class LineSweep {
  public:
    explicit LineSweep(const Lines& lines) : lines_(lines) {}

    // The horizons of the places of line n that somebody needs, into its row of `values`.
    void run(int n, Plane& values) {
        int low = 0;
        int high = lines_.columns() - 1;
        while (low <= high && !lines_.isNeeded(n, low))
            ++low;
        while (high >= low && !lines_.isNeeded(n, high))
            --high;
        if (low > high)
            return;
        const int ahead = lines_.direction().ahead;
        const int far = ahead > 0 ? high + lines_.reach() : low - lines_.reach();
        const int last = ahead > 0 ? low : high;
        hull_.clear();
        double depth = lines_.depth(n, far);
        hull_.add(ahead * far, depth);
        for (int x = far; x != last;) {
            const double slope = pass(n, x, depth);
            x -= ahead;
            if (x >= low && x <= high)
                values.at(x, lines_.slot(n)) =
                    static_cast<float>(std::max(0.0, slope / lines_.direction().length));
        }
    }

  private:
    // From column x, where the surface has this depth, to the one before it; the slope of the
    // horizon there. A line passes at most one border between rows on the way.
    double pass(int n, int x, double& depth) {
        const double slope = lines_.direction().slope;
        const double before = x - lines_.direction().ahead;
        const double border = std::floor(std::max(lines_.row(n, x), lines_.row(n, before)) - kSame);
        if (border > std::min(lines_.row(n, x), lines_.row(n, before)) + kSame) {
            const double crossing = (border - n) / slope;
            addPiece(n, x, crossing, depth);
            return addPiece(n, crossing, before, depth);
        }
        return addPiece(n, x, before, depth);
    }

    // The piece of one cell from place `from`, where the surface has this depth, back to `to`.
    double addPiece(int n, double from, double to, double& depth) {
        const double middle = (from + to) / 2;
        const double end = lines_.depth(n, to);
        const int ahead = lines_.direction().ahead;
        hull_.add(ahead * middle, 2 * lines_.depth(n, middle) - (depth + end) / 2);
        depth = end;
        return hull_.add(ahead * to, end);
    }

    const Lines& lines_;
    Hull hull_;
};

// The value at a texel, in the lines' axes, from the lines on its two sides.
double between(const Lines& lines, const Plane& values, int x, int y) {
    const double number = y - lines.direction().slope * x;
    const double below = std::floor(number + kSame);
    const double share = number - below;
    const int n = static_cast<int>(below);
    const double value = values.at(x, lines.slot(n));
    return share < kSame ? value : value + share * (values.at(x, lines.slot(n + 1)) - value);
}

}  // namespace

double azimuthOf(int index, int count) {
    return 2.0 * std::numbers::pi * index / count;
}

Plane buildHorizon(const DepthMap& map, double azimuth) {
    const Lines lines(map, directionOf(map, azimuth));
    Plane values(lines.columns(), lines.period());
    tbb::parallel_for(lines.first(), lines.end(), [&](int n) { LineSweep(lines).run(n, values); });
    Plane horizon(map.width(), map.height());
    tbb::parallel_for(0, map.height(), [&](int j) {
        for (int i = 0; i < map.width(); ++i)
            horizon.at(i, j) = static_cast<float>(
                map.width() * (lines.direction().alongRows ? between(lines, values, i, j)
                                                           : between(lines, values, j, i)));
    });
    return horizon;
}

}  // namespace relievo::preprocess
