#include "preprocess/outline_creases.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "textures/shape_map.h"

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

// What a corner makes of a sample.
struct Creased {
    double distance;
    double code;  // of textures::ShapeCreases, in texels
};

struct Corner {
    glm::dvec2 place{0.0};
    bool isConvex = true;
    double reach = 0.0;  // how far away samples may change
    Side before;
    Side behind;
    bool isSwapped = false;  // A is the side behind

    [[nodiscard]] double toA(const glm::dvec2& where) const {
        return (isSwapped ? behind : before).distance(where);
    }
    [[nodiscard]] double toB(const glm::dvec2& where) const {
        return (isSwapped ? before : behind).distance(where);
    }
    [[nodiscard]] double distance(const glm::dvec2& where) const {
        return isConvex ? std::max(toA(where), toB(where)) : std::min(toA(where), toB(where));
    }
    // Whether the distance of a place is that to A.
    [[nodiscard]] bool isOnA(const glm::dvec2& where) const {
        return (toA(where) > toB(where)) == isConvex;
    }
    [[nodiscard]] double code(const glm::dvec2& where) const {
        const double size =
            std::abs(toA(where) - toB(where)) + (isConvex ? 0.0 : textures::kReflexTexels);
        return isOnA(where) ? -size : size;
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

// A sample that a corner changes: creased, or only in its distance.
struct Sample {
    glm::ivec2 texel;
    double share;  // how far away from the corner, of its reach
    Creased value;
    bool isCreased;
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
    if (std::abs(corner.distance(glm::dvec2(i + 1, j + 1))) > kHalfDiagonal)
        return false;
    for (const int y : {j, j + 1})
        for (const int x : {i, i + 1})
            if (std::abs(distances.at(x, y)) < kHalfDiagonal)
                return true;
    return false;
}

// Whether the cell has samples on both sides of the crease.
bool isCreased(const Corner& corner, int i, int j) {
    int onA = 0;
    for (const int y : {j, j + 1})
        for (const int x : {i, i + 1})
            onA += corner.isOnA(glm::dvec2(x + 0.5, y + 0.5)) ? 1 : 0;
    return onA % 4 != 0;
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
            const Creased value{corner.distance(place), need.ofCrease ? corner.code(place) : 0.0};
            isAlone = isAlone && agrees(corner, value.distance, distances.at(i, j));
            samples.push_back({{i, j}, share, value, need.ofCrease});
        }
    return samples;
}

bool isInTile(const glm::dvec2& place, const Plane& plane) {
    return place.x >= 0.0 && place.y >= 0.0 && place.x < plane.width && place.y < plane.height;
}

// Whether codes of different corners in one cell would crease it, or not let it be continued by its
// neighbours: those of the two kinds share none.
bool clash(double a, double b) {
    const bool isSameKind =
        (std::abs(a) < textures::kReflexTexels) == (std::abs(b) < textures::kReflexTexels);
    return !isSameKind || a * b < 0.0;
}

// The texels of a tile.
struct Tile {
    int width;
    int height;
    WrapMode wrap;

    // Between two of them, or to the nearest copy: under mirror and clamp that is a texel itself.
    [[nodiscard]] double way(const glm::ivec2& a, const glm::ivec2& b) const {
        glm::ivec2 way = glm::abs(a - b);
        if (wrap == WrapMode::Repeat)
            way = glm::min(way, glm::ivec2(width, height) - way);
        return std::hypot(way.x, way.y);
    }
    // Visits what is up to one texel away in both directions: visit(texel).
    template <class Visit>
    void visitAround(const glm::ivec2& place, const Visit& visit) const {
        for (int j = place.y - 1; j <= place.y + 1; ++j)
            for (int i = place.x - 1; i <= place.x + 1; ++i)
                visit(glm::ivec2(textures::wrapIndex(i, width, wrap),
                                 textures::wrapIndex(j, height, wrap)));
    }
};

// Writes the samples of one corner after the other, unless they clash with those before.
class CreaseMap {
  public:
    CreaseMap(const Plane& distance, WrapMode wrap)
        : tile_{distance.width, distance.height, wrap},
          share_(distance.width, distance.height, 1.0f),
          result{distance, Plane(distance.width, distance.height), {}} {}

    [[nodiscard]] bool accepts(const std::vector<Sample>& samples) const {
        return std::none_of(samples.begin(), samples.end(),
                            [&](const Sample& sample) { return clashes(sample); });
    }

    void write(const std::vector<Sample>& samples) {
        for (const Sample& sample : samples) {
            float& share = share_.at(sample.texel.x, sample.texel.y);
            // Where a crease is needed it stays; of two corners that need none the nearer counts.
            const auto needed = sample.isCreased ? kCreased : static_cast<float>(sample.share);
            if (needed >= share)
                continue;
            share = needed;
            changed.push_back(sample.texel);
            result.code.at(sample.texel.x, sample.texel.y) = static_cast<float>(sample.value.code);
            result.distance.at(sample.texel.x, sample.texel.y) =
                static_cast<float>(sample.value.distance);
        }
    }

  private:
    static constexpr float kCreased = -1.0f;

    [[nodiscard]] bool clashes(const Sample& sample) const {
        if (!sample.isCreased)
            return false;
        bool result_ = false;
        tile_.visitAround(sample.texel, [&](const glm::ivec2& other) {
            if (share_.at(other.x, other.y) != kCreased)
                return;
            const double code = result.code.at(other.x, other.y);
            result_ = result_ || (other == sample.texel ? std::abs(code - sample.value.code) > 1e-3
                                                        : clash(code, sample.value.code));
        });
        return result_;
    }

    Tile tile_;
    Plane share_;  // of the corner that has a sample; kCreased where there is a crease

  public:
    CreasedDistances result;
    std::vector<glm::ivec2> changed;
};

// The highest field that is nowhere above some samples and differs between two texels by no more
// than the way between them, where all other samples do so already.
class StepField {
  public:
    StepField(const Plane& samples, WrapMode wrap)
        : tile_{samples.width, samples.height, wrap}, visits_(samples.texels.size()), s(samples) {}

    void lower(const glm::ivec2& texel, double most) {
        float& there = s.at(texel.x, texel.y);
        there = std::min(there, static_cast<float>(most));
    }

    // What s of one texel asks of those around.
    void spreadFrom(const glm::ivec2& source) {
        // A path over texels keeps within half a diagonal of the straight line, along which samples
        // that must be lowered lie: on the path they may miss that by twice as much.
        constexpr double kAstray = 1.42;
        const double here = s.at(source.x, source.y);
        ++visit_;
        open_.assign(1, source);
        while (!open_.empty()) {
            const glm::ivec2 place = open_.back();
            open_.pop_back();
            tile_.visitAround(place, [&](const glm::ivec2& texel) {
                std::uint32_t& visit = visits_[s.index(texel.x, texel.y)];
                const double most = here + tile_.way(source, texel);
                if (visit == visit_ || !(most < s.at(texel.x, texel.y) + kAstray))
                    return;
                visit = visit_;
                open_.push_back(texel);
                lower(texel, most);
            });
        }
    }

  private:
    Tile tile_;
    std::vector<std::uint32_t> visits_;  // which source came to a texel last
    std::uint32_t visit_ = 0;
    std::vector<glm::ivec2> open_;

  public:
    Plane s;
};

// What a sample allows: a convex crease comes down to the mean of A and B.
double mostStep(const CreasedDistances& creased, const glm::ivec2& texel) {
    const double c = std::abs(creased.code.at(texel.x, texel.y));
    return creased.distance.at(texel.x, texel.y) - (c < textures::kReflexTexels ? 0.5 * c : 0.0);
}

Plane stepsOf(const CreaseMap& map, const Plane& distance, WrapMode wrap) {
    StepField field(distance, wrap);
    std::vector<glm::ivec2> sources;
    for (const glm::ivec2& texel : map.changed) {
        const double most = mostStep(map.result, texel);
        if (!(most < distance.at(texel.x, texel.y)))
            continue;
        field.lower(texel, most);
        sources.push_back(texel);
    }
    for (const glm::ivec2& source : sources)
        field.spreadFrom(source);
    return std::move(field.s);
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
            ++(isSharp ? map.result.sharpCorners : map.result.roundCorners);
    }
    map.result.step = stepsOf(map, distance, wrap);
    return std::move(map.result);
}

}  // namespace relievo::preprocess
