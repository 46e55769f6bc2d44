#include "preprocess/outline_creases.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "preprocess/outline_corners.h"
#include "preprocess/step_field.h"
#include "textures/shape_map.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::WrapMode;

// How far creases are followed from their corner, in texels: as far as its sides are known.
constexpr double kLongestCrease = kSideLength / 1.5;

// A sample that a corner changes.
struct Sample {
    glm::ivec2 texel;
    double away;  // from the corner, as a share of its reach
    double distance;
    double code;  // in texels; 0: only the distance changes
};

// Signed distances of a map and of what continues it.
struct Distances {
    const Plane& plane;
    WrapMode wrap;
    [[nodiscard]] bool isInTile(int i, int j) const {
        return i >= 0 && j >= 0 && i < plane.width && j < plane.height;
    }
    [[nodiscard]] glm::ivec2 texel(int i, int j) const {
        return {textures::wrapIndex(i, plane.width, wrap),
                textures::wrapIndex(j, plane.height, wrap)};
    }
    [[nodiscard]] double at(int i, int j) const {
        const glm::ivec2 here = texel(i, j);
        return plane.at(here.x, here.y);
    }
};

// The distances to the sides of a corner, which have many segments: each place is measured once.
class MeasuredCorner {
  public:
    explicit MeasuredCorner(const OutlineCorner& corner) : corner_(corner) {}

    [[nodiscard]] const OutlineCorner& corner() const { return corner_; }
    // At the centre of texel (i,j).
    const SideDistances& atTexel(int i, int j) { return at(2 * i + 1, 2 * j + 1); }
    // At the centre of the cell between samples (i,j) and (i+1,j+1).
    const SideDistances& atCell(int i, int j) { return at(2 * i + 2, 2 * j + 2); }

  private:
    // In half texels.
    const SideDistances& at(int x, int y) {
        const auto key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32U |
                         static_cast<std::uint32_t>(x);
        const auto [found, isNew] = measured_.try_emplace(key);
        if (isNew)
            found->second = corner_.sides(0.5 * glm::dvec2(x, y));
        return found->second;
    }

    const OutlineCorner& corner_;
    std::unordered_map<std::uint64_t, SideDistances> measured_;
};

// Whether the cell between samples (i,j) and (i+1,j+1) may have the outline in it, and a part of it
// that the corner knows of: its centre and one of its samples are then no further from it than half
// the diagonal.
bool mayHaveOutline(MeasuredCorner& sides, const Distances& distances, int i, int j) {
    constexpr double kHalfDiagonal = 0.70711;
    if (std::abs(sides.corner().distance(sides.atCell(i, j))) > kHalfDiagonal)
        return false;
    for (const int y : {j, j + 1})
        for (const int x : {i, i + 1})
            if (std::abs(distances.at(x, y)) < kHalfDiagonal)
                return true;
    return false;
}

// Whether the cell between samples (i,j) and (i+1,j+1) has some on both sides of the crease.
bool isCreased(MeasuredCorner& sides, int i, int j) {
    int onA = 0;
    for (const int y : {j, j + 1})
        for (const int x : {i, i + 1})
            onA += sides.corner().isOnA(sides.atTexel(x, y)) ? 1 : 0;
    return onA % 4 != 0;
}

// What the cells around a sample want of it.
struct Need {
    bool ofValue = false;   // the distance as the corner has it
    bool ofCrease = false;  // a code as well
};

Need needOf(MeasuredCorner& sides, const Distances& distances, int i, int j) {
    Need need;
    for (const int y : {j - 1, j})
        for (const int x : {i - 1, i})
            if (mayHaveOutline(sides, distances, x, y)) {
                need.ofValue = true;
                need.ofCrease = need.ofCrease || isCreased(sides, x, y);
            }
    return need;
}

// Nothing else is near: where the corner is sharp distances are those to its sides, and on the
// other side of the outline they are nowhere smaller.
bool agrees(const OutlineCorner& corner, double f, double distance) {
    constexpr double kTolerance = 0.05;
    const double sign = corner.isConvex ? 1.0 : -1.0;
    const double difference = sign * (f - distance);
    return difference < kTolerance &&
           (sign * distance < 0.0 ? difference > -kTolerance : sign * f > -kTolerance);
}

// How far away from a corner samples may change: cells up to 1.5 texels beside one side must not be
// nearer to the other.
double reachOf(const OutlineCorner& corner) {
    return std::min(1.5 + 1.5 * std::tan(0.5 * corner.turn), kFarApart);
}

// The samples that a corner changes.
struct CornerSamples {
    std::vector<Sample> samples;
    bool isAlone = true;  // nothing else is too near
};

CornerSamples samplesOf(const OutlineCorner& corner, const Distances& distances) {
    const double reach = reachOf(corner);
    const int most = static_cast<int>(std::ceil(reach));
    const int x = static_cast<int>(std::floor(corner.place.x));
    const int y = static_cast<int>(std::floor(corner.place.y));
    MeasuredCorner sides(corner);
    CornerSamples result;
    for (int j = std::max(0, y - most); j <= std::min(distances.plane.height - 1, y + most); ++j)
        for (int i = std::max(0, x - most); i <= std::min(distances.plane.width - 1, x + most);
             ++i) {
            const glm::dvec2 place(i + 0.5, j + 0.5);
            const double away = glm::distance(place, corner.place) / reach;
            if (away >= 1.0)
                continue;
            const Need need = needOf(sides, distances, i, j);
            if (!need.ofValue)
                continue;
            const double distance = corner.distance(sides.atTexel(i, j));
            const double code = need.ofCrease ? corner.code(sides.atTexel(i, j)) : 0.0;
            result.isAlone = result.isAlone && agrees(corner, distance, distances.at(i, j)) &&
                             (!corner.isConvex || std::abs(code) < textures::kLeastReflexTexels);
            result.samples.push_back({{i, j}, away, distance, code});
        }
    return result;
}

bool isInTile(const glm::dvec2& place, const Plane& plane) {
    return place.x >= 0.0 && place.y >= 0.0 && place.x < plane.width && place.y < plane.height;
}

// Whether codes of different corners in one cell would crease it, or not let it be continued by its
// neighbours: those of the two kinds share none.
bool clash(double a, double b) {
    const bool isSameKind = (std::abs(a) < textures::kLeastReflexTexels) ==
                            (std::abs(b) < textures::kLeastReflexTexels);
    return !isSameKind || a * b < 0.0;
}

// What corners change, one after the other, unless they clash with those before.
class CreaseMap {
  public:
    explicit CreaseMap(const Distances& distances) : distances_(distances) {}

    // Whether samples of a corner go together with what others have there.
    [[nodiscard]] bool accepts(std::size_t corner, const std::vector<Sample>& samples) const {
        return std::none_of(samples.begin(), samples.end(),
                            [&](const Sample& sample) { return clashes(corner, sample); });
    }

    void write(std::size_t corner, const std::vector<Sample>& samples) {
        for (const Sample& sample : samples) {
            const auto [found, isNew] =
                entries_.try_emplace(indexOf(sample.texel), Entry{corner, sample});
            // Where a crease is needed it stays; of two corners that need none the nearer counts.
            if (!isNew && found->second.sample.code == 0.0 &&
                (sample.code != 0.0 || sample.away < found->second.sample.away))
                found->second = {corner, sample};
        }
    }

    // Changes the distances that it was made of, and codes. Returns for each corner what its
    // samples allow of steps.
    [[nodiscard]] std::vector<std::vector<StepBound>> writeTo(Plane& distance, Plane& code) const;

  private:
    struct Entry {
        std::size_t corner;
        Sample sample;
    };

    [[nodiscard]] std::size_t indexOf(const glm::ivec2& texel) const {
        return distances_.plane.index(texel.x, texel.y);
    }
    [[nodiscard]] bool clashes(std::size_t corner, const Sample& sample) const;

    const Distances& distances_;
    std::unordered_map<std::size_t, Entry> entries_;
};

bool CreaseMap::clashes(std::size_t corner, const Sample& sample) const {
    if (sample.code == 0.0)
        return false;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const glm::ivec2 place = distances_.texel(sample.texel.x + x, sample.texel.y + y);
            const auto found = entries_.find(indexOf(place));
            if (found == entries_.end() || found->second.corner == corner ||
                found->second.sample.code == 0.0)
                continue;
            const double code = found->second.sample.code;
            if (place == sample.texel ? std::abs(code - sample.code) > 1e-3
                                      : clash(code, sample.code))
                return true;
        }
    return false;
}

std::vector<std::vector<StepBound>> CreaseMap::writeTo(Plane& distance, Plane& code) const {
    std::map<std::size_t, std::vector<StepBound>> byCorner;
    for (const auto& [index, entry] : entries_) {
        const Sample& sample = entry.sample;
        // A convex crease comes down to the mean of A and B.
        const double c = std::abs(sample.code);
        const double most = sample.distance - (c < textures::kLeastReflexTexels ? 0.5 * c : 0.0);
        if (most < static_cast<double>(distance.texels[index]))
            byCorner[entry.corner].push_back({sample.texel, most});
        distance.texels[index] = static_cast<float>(sample.distance);
        code.texels[index] = static_cast<float>(sample.code);
    }
    std::vector<std::vector<StepBound>> bounds;
    for (auto& [corner, group] : byCorner)
        bounds.push_back(std::move(group));
    return bounds;
}

// Follows the crease outside of a reflex corner from cell to cell away from the outline, to where
// the nearest point of the outline is on neither side any more, or another crease comes.
class CreaseTrail {
  public:
    CreaseTrail(const OutlineCorner& corner, std::size_t number, const Distances& distances)
        : sides_(corner), number_(number), distances_(distances) {}

    // Measures the sides wherever it may lead: what takes long and needs no other trail.
    void explore() {
        walk([](const std::vector<Sample>&) { return true; });
    }

    void follow(CreaseMap& map) {
        walk([&](const std::vector<Sample>& samples) {
            if (!map.accepts(number_, samples))
                return false;
            map.write(number_, samples);
            return true;
        });
    }

  private:
    // On from each cell whose samples `take` accepts.
    template <typename Take>
    void walk(const Take& take) {
        std::set<std::pair<int, int>> seen;
        std::vector<glm::ivec2> open;
        const auto visitAround = [&](const glm::ivec2& cell) {
            for (int j = cell.y - 1; j <= cell.y + 1; ++j)
                for (int i = cell.x - 1; i <= cell.x + 1; ++i)
                    if (seen.insert({i, j}).second)
                        open.emplace_back(i, j);
        };
        visitAround(glm::ivec2(glm::floor(sides_.corner().place - 0.5)));
        while (!open.empty()) {
            const glm::ivec2 cell = open.back();
            open.pop_back();
            const Cell found = look(cell);
            if (found.isBesideCorner || (found.isCreased && take(found.samples)))
                visitAround(cell);
        }
    }

    struct Cell {
        bool isBesideCorner = false;  // it has the crease of the corner already
        bool isCreased = false;
        std::vector<Sample> samples;
    };

    Cell look(const glm::ivec2& cell) {
        constexpr double kAtCorner = 2.0;
        const OutlineCorner& corner = sides_.corner();
        const double away = glm::distance(glm::dvec2(cell) + 1.0, corner.place);
        if (away > kLongestCrease || !isCreased(sides_, cell.x, cell.y))
            return {};
        Cell result{false, true, {}};
        for (const int y : {cell.y, cell.y + 1})
            for (const int x : {cell.x, cell.x + 1}) {
                const SideDistances& sides = sides_.atTexel(x, y);
                const double distance = distances_.at(x, y);
                if (distances_.wrap != WrapMode::Repeat && !distances_.isInTile(x, y))
                    return {};
                // Along the crease both sides are nearest, as far as distances tell.
                if (std::abs(corner.distance(sides) - distance) > kTolerance)
                    return {away < kAtCorner, false, {}};
                result.samples.push_back(
                    {distances_.texel(x, y), 0.0, distance, corner.code(sides)});
            }
        return result;
    }

    static constexpr double kTolerance = 0.01;

    MeasuredCorner sides_;
    std::size_t number_;
    const Distances& distances_;
};

}  // namespace

CreasedDistances creaseCorners(const std::vector<BoundarySegment>& boundary, Plane distance,
                               WrapMode wrap, double leastTurn) {
    const Distances distances{distance, wrap};
    const OutlineCorners outline = outlineCorners(boundary, leastTurn);
    const std::vector<OutlineCorner>& corners = outline.corners;
    std::vector<CornerSamples> found(corners.size());
    tbb::parallel_for(std::size_t{0}, corners.size(),
                      [&](std::size_t k) { found[k] = samplesOf(corners[k], distances); });
    CreaseMap map(distances);
    CreasedDistances result;
    std::vector<CreaseTrail> trails;
    for (const glm::dvec2& place : outline.crowded)
        result.roundCorners += isInTile(place, distance) ? 1 : 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto& [samples, isAlone] = found[k];
        const bool isSharp = isAlone && map.accepts(k, samples);
        if (isSharp)
            map.write(k, samples);
        if (!isInTile(corners[k].place, distance))
            continue;
        ++(isSharp ? result.sharpCorners : result.roundCorners);
        // Inside of convex corners creases would lower the steps along all of their sides.
        if (isSharp && !corners[k].isConvex)
            trails.emplace_back(corners[k], k, distances);
    }
    if (result.sharpCorners > 0) {
        tbb::parallel_for(std::size_t{0}, trails.size(),
                          [&](std::size_t k) { trails[k].explore(); });
        tbb::parallel_invoke(
            [&] {
                for (CreaseTrail& trail : trails)
                    trail.follow(map);
            },
            [&] { result.step = distance; },
            [&] { result.code = Plane(distance.width, distance.height); });
        lowerToBounds(result.step, wrap, map.writeTo(distance, result.code));
    }
    result.distance = std::move(distance);
    return result;
}

}  // namespace relievo::preprocess
