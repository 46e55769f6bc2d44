#include "preprocess/outline_creases.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::WrapMode;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// Corners that are further apart along the boundary do not meet in a cell.
constexpr double kFarApart = 12.0;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

glm::dvec2 alongOf(const BoundarySegment& segment) {
    return segment.end - segment.start;
}

bool isTurn(const BoundarySegment& before, const BoundarySegment& behind) {
    const glm::dvec2 a = alongOf(before);
    const glm::dvec2 b = alongOf(behind);
    return glm::dot(a, b) < kCornerCosine * glm::length(a) * glm::length(b);
}

// Which segment goes on where one ends: mostly the next, but paths are closed, and parts of them
// may have been left out.
class Paths {
  public:
    explicit Paths(const std::vector<BoundarySegment>& segments)
        : segments_(segments), next_(segments.size(), kNone), before_(segments.size(), kNone) {
        for (std::size_t k = 0; k + 1 < segments.size(); ++k)
            if (segments[k].end == segments[k + 1].start)
                join(k, k + 1);
        std::map<std::pair<double, double>, std::size_t> starts;
        for (std::size_t k = 0; k < segments.size(); ++k)
            if (before_[k] == kNone)
                starts.try_emplace({segments[k].start.x, segments[k].start.y}, k);
        for (std::size_t k = 0; k < segments.size(); ++k) {
            if (next_[k] != kNone)
                continue;
            const auto found = starts.find({segments[k].end.x, segments[k].end.y});
            if (found != starts.end() && before_[found->second] == kNone)
                join(k, found->second);
        }
    }

    [[nodiscard]] std::size_t next(std::size_t k) const { return next_[k]; }
    [[nodiscard]] std::size_t before(std::size_t k) const { return before_[k]; }
    [[nodiscard]] const BoundarySegment& segment(std::size_t k) const { return segments_[k]; }
    // Whether there is a corner where segment k starts.
    [[nodiscard]] bool isCorner(std::size_t k) const {
        return before_[k] != kNone && isTurn(segments_[before_[k]], segments_[k]);
    }

  private:
    void join(std::size_t a, std::size_t b) {
        next_[a] = b;
        before_[b] = a;
    }
    const std::vector<BoundarySegment>& segments_;
    std::vector<std::size_t> next_;
    std::vector<std::size_t> before_;
};

// The boundary before (or behind) a corner, up to the next one, continued straight at both ends.
class Side {
  public:
    Side(const Paths& paths, std::size_t first, bool isForward) {
        double length = 0.0;
        for (std::size_t k = first; k != kNone && length < 2.0 * kFarApart;) {
            segments_.push_back(paths.segment(k));
            length += glm::length(alongOf(paths.segment(k)));
            const std::size_t next = isForward ? paths.next(k) : paths.before(k);
            if (next == first || (next != kNone && paths.isCorner(isForward ? next : k)))
                break;
            k = next;
        }
        length_ = length;
        (isForward ? segments_.front().start : segments_.front().end) -= continuation(isForward, 0);
        (isForward ? segments_.back().end : segments_.back().start) +=
            continuation(isForward, segments_.size() - 1);
    }

    // To the next corner, or more than kFarApart.
    [[nodiscard]] double length() const { return length_; }

    // < 0 inside.
    [[nodiscard]] double distance(const glm::dvec2& place) const {
        double nearest = std::numeric_limits<double>::infinity();
        double result = 0.0;
        for (const BoundarySegment& segment : segments_) {
            const glm::dvec2 along = alongOf(segment);
            const glm::dvec2 off = place - segment.start;
            const double share =
                std::clamp(glm::dot(off, along) / glm::dot(along, along), 0.0, 1.0);
            const glm::dvec2 away = off - share * along;
            const double square = glm::dot(away, away);
            if (square >= nearest)
                continue;
            nearest = square;
            result = -std::copysign(std::sqrt(square), cross(along, off));
        }
        return result;
    }

  private:
    // Straight on in the direction from the corner.
    [[nodiscard]] glm::dvec2 continuation(bool isForward, std::size_t k) const {
        const glm::dvec2 along = glm::normalize(alongOf(segments_[k]));
        return (isForward ? 1.0 : -1.0) * 4.0 * kFarApart * along;
    }
    std::vector<BoundarySegment> segments_;
    double length_ = 0.0;
};

struct Corner {
    glm::dvec2 place{0.0};
    bool isConvex = true;
    double reach = 0.0;  // how far away samples may change
    Side before;
    Side behind;
    bool isSwapped = false;  // A is the side behind

    // f and e. One side, A, is where e < 0 (or e > K) and the other where it is not.
    struct Values {
        double f;
        double e;
    };
    [[nodiscard]] Values at(const glm::dvec2& where) const {
        const double a = (isSwapped ? behind : before).distance(where);
        const double b = (isSwapped ? before : behind).distance(where);
        if (isConvex)
            return {std::max(a, b), std::clamp(b - a, -kCreaseLimit, kCreaseLimit)};
        return {std::min(a, b), std::clamp(kCreaseLimit + b - a, 0.0, 2.0 * kCreaseLimit)};
    }
};

Corner cornerAt(const Paths& paths, std::size_t k) {
    const glm::dvec2 in = glm::normalize(alongOf(paths.segment(paths.before(k))));
    const glm::dvec2 out = glm::normalize(alongOf(paths.segment(k)));
    // Cells up to 1.5 texels beside one side must not be nearer to the other.
    const double turn = std::acos(std::clamp(glm::dot(in, out), -1.0, 1.0));
    const double reach = 1.5 + 1.5 * std::tan(0.5 * turn);
    return {paths.segment(k).start, cross(in, out) > 0.0, std::min(reach, kFarApart),
            Side(paths, paths.before(k), false), Side(paths, k, true)};
}

// Neighbouring corners take the side between them for the same one of A and B, or the creases of
// the one would end in cells of the other. Where they are far apart it does not matter, so that
// each group of near ones is settled on its own, the same in all copies of a tile.
std::vector<Corner> cornersOf(const Paths& paths, std::size_t count) {
    std::vector<Corner> corners;
    std::vector<std::size_t> number(count, kNone);  // of the corner where a segment starts
    std::vector<std::size_t> starts;
    for (std::size_t k = 0; k < count; ++k)
        if (paths.isCorner(k)) {
            number[k] = corners.size();
            starts.push_back(k);
            corners.push_back(cornerAt(paths, k));
        }
    const auto nextCorner = [&](std::size_t corner) {
        std::size_t k = paths.next(starts[corner]);
        while (k != kNone && number[k] == kNone && k != starts[corner])
            k = paths.next(k);
        return k == kNone ? kNone : number[k];
    };
    std::vector<bool> isSettled(corners.size());
    const auto settleFrom = [&](std::size_t corner) {
        while (!isSettled[corner]) {
            isSettled[corner] = true;
            if (corners[corner].behind.length() > kFarApart)
                return;
            const std::size_t next = nextCorner(corner);
            if (next == kNone || isSettled[next])
                return;
            corners[next].isSwapped = !corners[corner].isSwapped;
            corner = next;
        }
    };
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
        if (corners[corner].before.length() > kFarApart)
            settleFrom(corner);
    // Small closed paths: from their first corner from above.
    std::vector<std::size_t> left;
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
        if (!isSettled[corner])
            left.push_back(corner);
    std::sort(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(corners[a].place.y, corners[a].place.x) <
               std::pair(corners[b].place.y, corners[b].place.x);
    });
    for (const std::size_t corner : left)
        settleFrom(corner);
    return corners;
}

// A sample that a corner changes.
struct Sample {
    int i;
    int j;
    double share;  // how far away from the corner, of its reach
    Corner::Values values;
    bool isCreased;  // e is needed, not only f
};

// Signed distances of a map and of what continues it.
struct Distances {
    const Plane& plane;
    WrapMode wrap;
    [[nodiscard]] double at(int i, int j) const {
        return plane.at(textures::wrapIndex(i, plane.width, wrap),
                        textures::wrapIndex(j, plane.height, wrap));
    }
};

// Whether the cell between samples (i,j) and (i+1,j+1) may have the outline in it, and a part of it
// that the corner knows of: its centre and one of its samples are then no further from it than half
// the diagonal.
bool mayHaveOutline(const Corner& corner, const Distances& distances, int i, int j) {
    constexpr double kHalfDiagonal = 0.70711;
    if (std::abs(corner.at(glm::dvec2(i + 1, j + 1)).f) > kHalfDiagonal)
        return false;
    for (const int y : {j, j + 1})
        for (const int x : {i, i + 1})
            if (std::abs(distances.at(x, y)) < kHalfDiagonal)
                return true;
    return false;
}

// Whether the cell has samples on both sides of the crease.
bool isCreased(const Corner& corner, int i, int j) {
    const double level = corner.isConvex ? 0.0 : kCreaseLimit;
    int above = 0;
    for (const int y : {j, j + 1})
        for (const int x : {i, i + 1})
            above += corner.at(glm::dvec2(x + 0.5, y + 0.5)).e > level ? 1 : 0;
    return above % 4 != 0;
}

// What the cells around a sample want of it.
struct Need {
    bool ofValue = false;   // f as the corner has it
    bool ofCrease = false;  // e as well
};
Need needOf(const Corner& corner, const Distances& distances, int i, int j) {
    Need need;
    for (const int y : {j - 1, j})
        for (const int x : {i - 1, i})
            if (mayHaveOutline(corner, distances, x, y)) {
                need.ofValue = true;
                need.ofCrease = need.ofCrease || isCreased(corner, x, y);
            }
    return need;
}

// Nothing else is near: where the corner is sharp distances are those to its sides, and on the
// other side of the outline they are nowhere smaller.
bool agrees(const Corner& corner, double f, double distance) {
    constexpr double kTolerance = 0.05;
    const double sign = corner.isConvex ? 1.0 : -1.0;
    const double difference = sign * (f - distance);
    return difference < kTolerance &&
           (sign * distance < 0.0 ? difference > -kTolerance : sign * f > -kTolerance);
}

// The samples that a corner changes; `isAlone` is false where something else is too near.
std::vector<Sample> samplesOf(const Corner& corner, const Distances& distances, bool& isAlone) {
    const int reach = static_cast<int>(std::ceil(corner.reach));
    const int x = static_cast<int>(std::floor(corner.place.x));
    const int y = static_cast<int>(std::floor(corner.place.y));
    std::vector<Sample> samples;
    for (int j = std::max(0, y - reach); j <= std::min(distances.plane.height - 1, y + reach); ++j)
        for (int i = std::max(0, x - reach); i <= std::min(distances.plane.width - 1, x + reach);
             ++i) {
            const glm::dvec2 place(i + 0.5, j + 0.5);
            const double share = glm::distance(place, corner.place) / corner.reach;
            if (share >= 1.0)
                continue;
            const Need need = needOf(corner, distances, i, j);
            if (!need.ofValue)
                continue;
            Corner::Values values = corner.at(place);
            values.e = need.ofCrease ? values.e : 0.0;
            isAlone = isAlone && agrees(corner, values.f, distances.at(i, j));
            samples.push_back({i, j, share, values, need.ofCrease});
        }
    return samples;
}

bool isInTile(const glm::dvec2& place, const Plane& plane) {
    return place.x >= 0.0 && place.y >= 0.0 && place.x < plane.width && place.y < plane.height;
}

// Whether two samples of different corners, `steps` apart, would crease a cell between them that
// should have none: f is bilinear where e is in [0, K], or on one side of it, and a free sample
// between has to be 0 beside the ones and K beside the others.
bool clash(double a, double b, int steps) {
    const auto [low, high] = std::minmax(a, b);
    if (steps > 1)
        return low < 0.0 && high > kCreaseLimit;
    return (low < 0.0 && high > 0.0) || (low < kCreaseLimit && high > kCreaseLimit);
}

// Writes the samples of one corner after the other, unless they clash with those before.
class CreaseMap {
  public:
    CreaseMap(const Plane& distance, WrapMode wrap)
        : wrap_(wrap),
          share_(distance.width, distance.height, 1.0f),
          creased{distance, Plane(distance.width, distance.height)} {}

    [[nodiscard]] bool accepts(const std::vector<Sample>& samples) const {
        return std::none_of(samples.begin(), samples.end(),
                            [&](const Sample& sample) { return clashes(sample); });
    }

    void write(const std::vector<Sample>& samples) {
        for (const Sample& sample : samples) {
            float& share = share_.at(sample.i, sample.j);
            // Where a crease is needed it stays; of two corners that need none the nearer counts.
            const auto needed = static_cast<float>(sample.isCreased ? -1.0 : sample.share);
            if (needed >= share)
                continue;
            share = needed;
            changed_.emplace_back(sample.i, sample.j);
            creased.crease.at(sample.i, sample.j) = static_cast<float>(sample.values.e);
            creased.distance.at(sample.i, sample.j) = static_cast<float>(
                sample.values.f - std::clamp(sample.values.e, 0.0, kCreaseLimit));
        }
    }

    void raiseAround();

  private:
    template <class Visit>
    void visitAround(const glm::ivec2& place, int steps, const Visit& visit) const {
        for (int j = place.y - steps; j <= place.y + steps; ++j)
            for (int i = place.x - steps; i <= place.x + steps; ++i)
                visit(glm::ivec2(textures::wrapIndex(i, share_.width, wrap_),
                                 textures::wrapIndex(j, share_.height, wrap_)),
                      std::max(std::abs(i - place.x), std::abs(j - place.y)));
    }
    [[nodiscard]] bool clashes(const Sample& sample) const {
        if (!sample.isCreased)
            return false;
        bool result = false;
        visitAround({sample.i, sample.j}, 2, [&](const glm::ivec2& other, int steps) {
            if (share_.at(other.x, other.y) >= 0.0f)
                return;
            const double e = creased.crease.at(other.x, other.y);
            result = result || (steps == 0 ? std::abs(e - sample.values.e) > 1e-3
                                           : clash(e, sample.values.e, steps));
        });
        return result;
    }

    WrapMode wrap_;
    Plane share_;  // of the corner that has a sample; −1 where it has a crease
    std::vector<glm::ivec2> changed_;

  public:
    CreasedDistances creased;
};

// Around creases where e crosses K other samples must have e = K, which leaves f as it is.
void CreaseMap::raiseAround() {
    const auto limit = static_cast<float>(kCreaseLimit);
    const Plane crease = creased.crease;
    for (const glm::ivec2& high : changed_) {
        if (crease.at(high.x, high.y) <= limit)
            continue;
        visitAround(high, 1, [&](const glm::ivec2& place, int) {
            float& e = creased.crease.at(place.x, place.y);
            if (e != 0.0f || share_.at(place.x, place.y) < 0.0f)
                return;
            e = limit;
            creased.distance.at(place.x, place.y) -= limit;
        });
    }
}

}  // namespace

CreasedDistances creaseCorners(const std::vector<BoundarySegment>& boundary, const Plane& distance,
                               WrapMode wrap) {
    CreaseMap map(distance, wrap);
    const Paths paths(boundary);
    for (const Corner& corner : cornersOf(paths, boundary.size())) {
        bool isAlone = true;
        const std::vector<Sample> samples = samplesOf(corner, {distance, wrap}, isAlone);
        const bool isSharp = isAlone && map.accepts(samples);
        if (isSharp)
            map.write(samples);
        if (isInTile(corner.place, distance))
            ++(isSharp ? map.creased.sharpCorners : map.creased.roundCorners);
    }
    map.raiseAround();
    return std::move(map.creased);
}

}  // namespace relievo::preprocess
