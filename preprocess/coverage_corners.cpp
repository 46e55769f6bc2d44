#include "preprocess/coverage_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::WrapMode;

constexpr int kMostBetween = 12;      // points that give way
constexpr double kFarthest = 6.0;     // texels from the last sure point to the corner
constexpr double kLeastLength = 0.7;  // texels between the points that give a direction
constexpr double kLeastTurn = 0.766;  // cosine of the smallest turn, 40°
constexpr double kMostTurn = -0.98;   // beyond it two pieces are as good as parallel
constexpr double kBehind = 0.05;      // texels that a corner may lie behind a sure point
constexpr double kTolerance = 0.08;   // of coverage

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

// A straight piece of outline: the inside is to the right of its direction.
struct Line {
    glm::dvec2 place;
    glm::dvec2 along;  // of unit length

    // How far outside a place is.
    [[nodiscard]] double outside(const glm::dvec2& point) const {
        return cross(point - place, along);
    }
};

// A convex polygon of few corners.
struct Polygon {
    std::array<glm::dvec2, 8> corners;
    std::size_t count = 0;

    void add(const glm::dvec2& corner) { corners[count++] = corner; }
    [[nodiscard]] double area() const {
        double doubled = 0.0;
        for (std::size_t k = 0; k < count; ++k)
            doubled += cross(corners[k], corners[(k + 1) % count]);
        return 0.5 * doubled;
    }
};

// The part of a polygon inside a line (sign 1) or outside (−1).
Polygon cut(const Polygon& polygon, const Line& line, double sign) {
    Polygon result;
    for (std::size_t k = 0; k < polygon.count; ++k) {
        const glm::dvec2& a = polygon.corners[k];
        const glm::dvec2& b = polygon.corners[(k + 1) % polygon.count];
        const double atA = sign * line.outside(a);
        const double atB = sign * line.outside(b);
        if (atA <= 0.0)
            result.add(a);
        if ((atA < 0.0 && atB > 0.0) || (atA > 0.0 && atB < 0.0))
            result.add(a + atA / (atA - atB) * (b - a));
    }
    return result;
}

// Two lines that meet, and what they enclose.
struct Corner {
    Line before;
    Line after;
    glm::dvec2 place;

    [[nodiscard]] double coverage(const glm::dvec2& texel) const {
        Polygon square;
        for (const glm::dvec2& corner : {glm::dvec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
            square.add(texel + corner);
        const bool isConvex = cross(before.along, after.along) > 0.0;
        const double sign = isConvex ? 1.0 : -1.0;
        const double area = cut(cut(square, before, sign), after, sign).area();
        return isConvex ? area : 1.0 - area;
    }
};

std::optional<Corner> meet(const Line& before, const Line& after) {
    const double turn = glm::dot(before.along, after.along);
    if (turn > kLeastTurn || turn < kMostTurn)
        return std::nullopt;
    const double further =
        cross(after.place - before.place, after.along) / cross(before.along, after.along);
    const glm::dvec2 place = before.place + further * before.along;
    const double back = glm::dot(after.place - place, after.along);
    if (std::min(further, back) < -kBehind || std::max(further, back) > kFarthest)
        return std::nullopt;
    return Corner{before, after, place};
}

// The points of a chain by numbers that go on around it.
class ChainPoints {
  public:
    explicit ChainPoints(const OutlineChain& chain)
        : chain_(chain), count_(static_cast<int>(chain.points.size())) {}

    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] int number(int k) const { return ((k % count_) + count_) % count_; }
    [[nodiscard]] bool exists(int k) const { return chain_.isClosed || (k >= 0 && k < count_); }
    [[nodiscard]] bool isSure(int k) const {
        return exists(k) && chain_.points[static_cast<std::size_t>(number(k))].isSure;
    }
    [[nodiscard]] glm::dvec2 place(int k) const {
        const int around = (k - number(k)) / count_;
        return chain_.points[static_cast<std::size_t>(number(k))].place +
               static_cast<double>(around) * chain_.period;
    }
    // The line through sure point k and the one before it (step −1) or after it (1).
    [[nodiscard]] std::optional<Line> line(int k, int step) const {
        if (!isSure(k))
            return std::nullopt;
        for (int other = k + step; std::abs(other - k) <= 3 && isSure(other); other += step) {
            const glm::dvec2 along = static_cast<double>(step) * (place(other) - place(k));
            const double length = glm::length(along);
            if (length >= kLeastLength)
                return Line{place(k), along / length};
        }
        return std::nullopt;
    }

  private:
    const OutlineChain& chain_;
    int count_;
};

// A chain that ends at mirrors with as many of its own points behind them as corners reach to, so
// that those on a mirror are seen. Its ends on the border, which lie beside the true outline, are
// left out.
class MirroredChain {
  public:
    MirroredChain(const OutlineChain& chain, const Plane& coverage)
        : size_(coverage.width, coverage.height) {
        const auto count = static_cast<int>(chain.points.size());
        const auto point = [&](int k) { return chain.points[static_cast<std::size_t>(k)]; };
        for (int k = std::min(count - 2, kMostBetween); k >= 1; --k)
            chain_.points.push_back(behind(point(k), point(0).place));
        for (int k = 1; k < count - 1; ++k)
            chain_.points.push_back(point(k));
        for (int k = count - 2; k >= std::max(1, count - 1 - kMostBetween); --k)
            chain_.points.push_back(behind(point(k), point(count - 1).place));
        chain_.isClosed = false;
    }

    [[nodiscard]] OutlineChain& chain() { return chain_; }

    // What of the chain is in the tile: from where it comes in first to where it goes out last.
    [[nodiscard]] std::vector<OutlinePoint> inTile() const {
        const auto& points = chain_.points;
        std::vector<OutlinePoint> result;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const bool isIn = isInTile(points[k].place);
            if (k > 0 && isIn != isInTile(points[k - 1].place))
                result.push_back({onBorder(points[k - 1].place, points[k].place), true});
            if (isIn)
                result.push_back(points[k]);
        }
        return result;
    }

  private:
    // Behind the side that `border` lies on.
    [[nodiscard]] OutlinePoint behind(OutlinePoint point, const glm::dvec2& border) const {
        for (int axis = 0; axis < 2; ++axis)
            if (border[axis] == 0.0 || border[axis] == size_[axis]) {
                point.place[axis] = 2.0 * border[axis] - point.place[axis];
                return point;
            }
        return point;
    }
    [[nodiscard]] bool isInTile(const glm::dvec2& place) const {
        return place.x >= 0.0 && place.y >= 0.0 && place.x <= size_.x && place.y <= size_.y;
    }
    // Where the way from one to the other, of which one is in the tile, meets its border.
    [[nodiscard]] glm::dvec2 onBorder(const glm::dvec2& a, const glm::dvec2& b) const {
        for (int axis = 0; axis < 2; ++axis)
            for (const double side : {0.0, size_[axis]})
                if ((a[axis] < side) != (b[axis] < side) && a[axis] != b[axis]) {
                    const double share = (side - a[axis]) / (b[axis] - a[axis]);
                    glm::dvec2 place = a + share * (b - a);
                    place[axis] = side;
                    if (isInTile(place))
                        return place;
                }
        return isInTile(a) ? a : b;
    }

    glm::dvec2 size_;
    OutlineChain chain_;
};

// Ends on the border of a clamped tile lie straight behind the last point inside: they go on from
// there as the outline comes. No centre lies between, half a texel from the border.
void straightenEnd(OutlinePoint& end, const OutlinePoint& last, const OutlinePoint& before,
                   const glm::dvec2& size) {
    constexpr double kFarthestAside = 0.5;
    for (int axis = 0; axis < 2; ++axis) {
        if (end.place[axis] != 0.0 && end.place[axis] != size[axis])
            continue;
        const glm::dvec2 along = last.place - before.place;
        const double share = (end.place[axis] - last.place[axis]) / along[axis];
        if (!(share >= 0.0 && std::isfinite(share)))  // it comes along the border
            return;
        const double aside = std::clamp(share * along[1 - axis], -kFarthestAside, kFarthestAside);
        end.place[1 - axis] = std::clamp(last.place[1 - axis] + aside, 0.0, size[1 - axis]);
        return;
    }
}

void straightenEnds(OutlineChain& chain, const glm::dvec2& size) {
    auto& points = chain.points;
    if (chain.isClosed || points.size() < 3)
        return;
    straightenEnd(points[0], points[1], points[2], size);
    const std::size_t last = points.size() - 1;
    straightenEnd(points[last], points[last - 1], points[last - 2], size);
}

// How much a chain turns between two stretches of some points each, the first of which begins at
// point k: long enough for their directions to be known to a hundredth. Nothing where points are
// missing or not sure.
std::optional<double> bend(const ChainPoints& points, int k, int step) {
    constexpr int kStretch = 4;
    for (int other = 0; other <= 2 * kStretch; ++other)
        if (!points.isSure(k + other * step))
            return std::nullopt;
    const glm::dvec2 middle = points.place(k + kStretch * step);
    return std::abs(cross(glm::normalize(points.place(k) - middle),
                          glm::normalize(middle - points.place(k + 2 * kStretch * step))));
}

// Where one side of a corner is straight and the other is not, the straight line in place of that
// has met it too early or too late: by how much the corner moves along the straight side so that
// the coverage around is right. `excess` is what the two lines have too little, in texels of area.
glm::dvec2 settlement(const Corner& corner, double excess, const ChainPoints& points, int last,
                      int next) {
    constexpr double kCurved = 0.03;
    constexpr double kStraight = 0.3;      // of the other one's bend
    constexpr double kFarthestMove = 0.5;  // texels
    const std::optional<double> before = bend(points, last, -1);
    const std::optional<double> after = bend(points, next, 1);
    if (!before || !after || std::max(*before, *after) < kCurved ||
        std::min(*before, *after) > kStraight * std::max(*before, *after))
        return glm::dvec2(0.0);
    const glm::dvec2 along = *before < *after ? corner.before.along : corner.after.along;
    // The inside is to the right, so that areas are as those of polygons in this sense.
    const double areaPerTexel = 0.5 * cross(along, points.place(next) - points.place(last));
    if (std::abs(excess) > std::abs(areaPerTexel) * kFarthestMove)
        return glm::dvec2(0.0);
    return excess / areaPerTexel * along;
}

class Sharpener {
  public:
    Sharpener(const Plane& coverage, const TexelSides& sides, std::vector<std::size_t>& changed)
        : coverage_(coverage), sides_(sides), changed_(changed) {}

    void sharpen(OutlineChain& chain) {
        const ChainPoints points(chain);
        if (points.count() < 4)
            return;
        const auto count = static_cast<std::size_t>(points.count());
        isRemoved_.assign(count, false);
        isKept_.assign(count, false);
        corners_.assign(count, std::nullopt);
        findDirections(points);
        const int longest = std::min(kMostBetween, points.count() - 3);
        for (int between = 0; between <= longest; ++between)
            for (std::size_t k = 0; k < count; ++k)
                if (glm::dot(into_[k], onwards_[k + static_cast<std::size_t>(between) + 1]) <=
                    kLeastTurn)
                    tryCorner(points, static_cast<int>(k), static_cast<int>(k) + between + 1);
        rebuild(points, chain);
    }

  private:
    // Most pairs of directions turn too little for a corner, which is seen from them alone. A
    // direction that is none compares with nothing.
    void findDirections(const ChainPoints& points) {
        const glm::dvec2 none(std::numeric_limits<double>::quiet_NaN());
        const auto along = [&](const std::optional<Line>& line) {
            return line ? line->along : none;
        };
        into_.clear();
        onwards_.clear();
        for (int k = 0; k < points.count(); ++k) {
            into_.push_back(along(points.line(k, -1)));
            onwards_.push_back(along(points.line(k, 1)));
        }
        for (std::size_t k = 0; k <= kMostBetween; ++k)
            onwards_.push_back(points.exists(points.count()) ? onwards_[k] : none);
    }

    // Between points `last` and `next`.
    void tryCorner(const ChainPoints& points, int last, int next) {
        if (!isFree(points, last, next))
            return;
        std::optional<Corner> corner =
            meet(Line{points.place(last), into_[index(points, last)]},
                 Line{points.place(next), onwards_[index(points, next)]});
        const std::optional<double> more =
            corner ? excess(*corner, points, last, next) : std::nullopt;
        if (!more)
            return;
        corner->place += settlement(*corner, *more, points, last, next);
        flipBetween(*corner, points, last, next);
        corners_[index(points, last)] = corner->place;  // last is no number of another round
        for (int k = last + 1; k < next; ++k)
            isRemoved_[index(points, k)] = true;
        for (const int k : {last - 1, last, next, next + 1})
            if (points.exists(k))
                isKept_[index(points, k)] = true;
    }

    static std::size_t index(const ChainPoints& points, int k) {
        return static_cast<std::size_t>(points.number(k));
    }

    [[nodiscard]] bool isFree(const ChainPoints& points, int last, int next) const {
        if (corners_[index(points, last)])
            return false;
        for (int k = last - 1; k <= next + 1; ++k)
            if (points.exists(k) && (isRemoved_[index(points, k)] ||
                                     (k > last && k < next && isKept_[index(points, k)])))
                return false;
        return true;
    }

    // How much more of the texels around a corner is covered than by its two lines, in all: nothing
    // where a texel differs from them by too much.
    [[nodiscard]] std::optional<double> excess(const Corner& corner, const ChainPoints& points,
                                               int last, int next) const {
        glm::dvec2 least = corner.place;
        glm::dvec2 most = corner.place;
        for (int k = last - 1; k <= next + 1; ++k)
            if (points.exists(k)) {
                least = glm::min(least, points.place(k));
                most = glm::max(most, points.place(k));
            }
        const glm::ivec2 first(glm::floor(least - 0.5));
        const glm::ivec2 end(glm::floor(most + 0.5));
        double sum = 0.0;
        for (int j = first.y; j <= end.y; ++j)
            for (int i = first.x; i <= end.x; ++i) {
                const double difference = at(i, j) - corner.coverage({i, j});
                if (std::abs(difference) > kTolerance)
                    return std::nullopt;
                sum += difference;
            }
        return sum;
    }

    [[nodiscard]] float at(int i, int j) const {
        return coverage_.at(textures::wrapIndex(i, coverage_.width, sides_.wrap),
                            textures::wrapIndex(j, coverage_.height, sides_.wrap));
    }

    // Centres between the old way and the new one change sides.
    void flipBetween(const Corner& corner, const ChainPoints& points, int last, int next) {
        std::vector<glm::dvec2> loop{corner.place};
        for (int k = next; k >= last; --k)
            loop.push_back(points.place(k));
        sides_.appendWithin(loop, changed_);
    }

    void rebuild(const ChainPoints& points, OutlineChain& chain) const {
        std::vector<OutlinePoint> result;
        for (int k = 0; k < points.count(); ++k) {
            const std::size_t at = index(points, k);
            if (!isRemoved_[at])
                result.push_back({points.place(k), points.isSure(k)});
            if (corners_[at])
                result.push_back({*corners_[at], true});
        }
        chain.points = std::move(result);
    }

    const Plane& coverage_;
    const TexelSides& sides_;
    std::vector<std::size_t>& changed_;
    // Of the points of the chain.
    std::vector<glm::dvec2> into_;     // directions from the points before
    std::vector<glm::dvec2> onwards_;  // to the points behind; a closed chain goes on a little
    std::vector<bool> isRemoved_;
    std::vector<bool> isKept_;
    std::vector<std::optional<glm::dvec2>> corners_;  // that follow them
};

}  // namespace

void sharpenCorners(const Plane& coverage, const TexelSides& sides, OutlineChain& chain,
                    std::vector<std::size_t>& changed) {
    Sharpener sharpener(coverage, sides, changed);
    if (sides.wrap == WrapMode::Mirror && !chain.isClosed && chain.points.size() > 2) {
        MirroredChain mirrored(chain, coverage);
        sharpener.sharpen(mirrored.chain());
        chain.points = mirrored.inTile();
    } else {
        sharpener.sharpen(chain);
        straightenEnds(chain, {coverage.width, coverage.height});
    }
}

}  // namespace relievo::preprocess
