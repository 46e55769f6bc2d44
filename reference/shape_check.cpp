#include "reference/shape_check.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "reference/adversarial_rays.h"
#include "reference/surface_crossings.h"
#include "textures/bilinear.h"
#include "textures/depth_map.h"

namespace relievo::reference {
namespace {

using textures::DepthMap;
using textures::ShapeMap;

constexpr std::size_t kRaysPerTask = 4096;
constexpr double kTolerance = 1e-9;  // tile widths
constexpr double kLongestStepInTiles = 2.0;
constexpr double kLeastFree = 1e-3;  // texels that a step has at least, when it aims at nothing
constexpr float kHalfCode = 0.51f / 255.0f;

struct Tally {
    std::uint64_t violations = 0;
    std::uint64_t steps = 0;
    double length = 0.0;  // of all of them, in texels
    std::optional<ShapeViolation> worst;

    // The same whatever the order: of equally bad steps the first drawn counts.
    void offer(const ShapeViolation& other) {
        if (!worst || other.depth > worst->depth ||
            (other.depth == worst->depth && other.ray < worst->ray))
            worst = other;
    }
    void add(const Tally& other) {
        violations += other.violations;
        steps += other.steps;
        length += other.length;
        if (other.worst)
            offer(*other.worst);
    }
};

// The distances that steps go by as a relief: what is below its surface at the depth `offset` is in
// the solid.
struct Subject {
    const ShapeMap& shape;
    DepthMap relief;
    double least;  // offset

    Subject(const ShapeMap& map, const textures::Plane& distances, double leastOffset)
        : shape(map), relief{distances, map.wrap}, least(leastOffset) {}
    [[nodiscard]] glm::dvec2 size() const { return {shape.width(), shape.height()}; }
};

// Those of all offsets, and with creases those from where corners end.
std::vector<Subject> subjectsOf(const ShapeMap& map) {
    const double least = map.isSigned ? *std::ranges::min_element(map.steps().texels) : 0.0;
    std::vector<Subject> subjects{{map, map.steps(), least}};
    if (map.isCreased())
        subjects.emplace_back(map, map.distance, textures::kCornersEndTexels / map.width());
    return subjects;
}

glm::dvec2 drawStart(const Subject& subject, RayNumbers& numbers) {
    const glm::dvec2 place = drawPlace(subject.relief, numbers);
    if (numbers.below(4) != 0)
        return place;
    return (glm::floor(place * subject.size()) + 0.5) / subject.size();
}

// At the texel around where the map's own gradient says that the outline is, to which the distance
// falls the fastest.
std::optional<Heading> headingByGradient(const Subject& subject, const glm::dvec2& place,
                                         double distance) {
    constexpr int kAround = 3;
    const ShapeMap& shape = subject.shape;
    const glm::dvec2 texels = place * subject.size() - 0.5;
    const int i = std::min(static_cast<int>(place.x * shape.width()), shape.width() - 1);
    const int j = std::min(static_cast<int>(place.y * shape.height()), shape.height() - 1);
    const glm::dvec2 gradient(shape.gradientX.at(i, j), shape.gradientY.at(i, j));
    const glm::dvec2 guess = texels - distance * shape.width() * gradient;
    if (!(std::abs(guess.x) < 1e9 && std::abs(guess.y) < 1e9))
        return std::nullopt;
    std::optional<Heading> best;
    double steepest = 0.0;
    for (int dj = -kAround; dj <= kAround; ++dj)
        for (int di = -kAround; di <= kAround; ++di) {
            const auto column = std::llround(guess.x) + di;
            const auto row = std::llround(guess.y) + dj;
            const glm::dvec2 to = glm::dvec2(column, row) - texels;
            const double length = glm::length(to) / shape.width();
            const double fall = distance - static_cast<double>(subject.relief.at(column, row));
            if (length > 0.0 && fall > steepest * length) {
                steepest = fall / length;
                best =
                    Heading{to / subject.size() / length, Heading::Target{length, distance - fall}};
            }
        }
    return best;
}

Heading drawDirection(const Subject& subject, const glm::dvec2& place, double distance,
                      RayNumbers& numbers) {
    if (numbers.below(3) == 0)
        if (const std::optional<Heading> heading = headingByGradient(subject, place, distance))
            return *heading;
    return drawHeading(subject.relief, place, distance, numbers);
}

// That of the target, or one a bit above it, or any.
std::optional<double> drawOffset(const Subject& subject, double distance, const Heading& heading,
                                 RayNumbers& numbers) {
    const double most = distance - subject.shape.slack;
    const double texel = 1.0 / subject.shape.width();
    if (heading.target && numbers.below(4) != 0) {
        const double there = std::max(heading.target->depth, subject.least);
        const double above =
            numbers.below(2) == 0 ? 0.0 : (most - there) * numbers.logarithmic(1e-6, 1.0);
        return there + above < most ? std::optional(there + above) : std::nullopt;
    }
    const double least = kLeastFree * texel;
    if (!(most - subject.least > least))
        return std::nullopt;
    return most - numbers.logarithmic(least, most - subject.least);
}

// One step; nothing where there is none to take.
std::optional<ShapeViolation> drawStep(const Subject& subject, RayNumbers numbers) {
    const ShapeMap& shape = subject.shape;
    const glm::dvec2 place = drawStart(subject, numbers);
    const double distance =
        textures::sampleBilinear(subject.relief.depth, place.x, place.y, shape.wrap);
    const Heading heading = drawDirection(subject, place, distance, numbers);
    const std::optional<double> offset = drawOffset(subject, distance, heading, numbers);
    if (!offset)
        return std::nullopt;
    const double width = shape.width();
    const double free = (distance - *offset - shape.slack) * width;
    if (!(free > 0.0))
        return std::nullopt;
    ShapeViolation step;
    step.step = {{place, *offset}, {heading.direction, 0.0}};
    step.length = std::min(safeStep(free) / width, kLongestStepInTiles);
    const Excursion deepest = deepestBelow(subject.relief, step.step, step.length);
    step.worstAt = deepest.t;
    step.depth = deepest.depth;
    return step;
}

std::uint64_t countContradictions(const ShapeMap& shape) {
    std::uint64_t count = 0;
    for (std::size_t t = 0; t < shape.distance.texels.size(); ++t) {
        const float distance = shape.distance.texels[t];
        const float inside = shape.shape.texels[t];
        if ((distance > 0.0f && inside > 0.5f + kHalfCode) ||
            (distance < 0.0f && inside < 0.5f - kHalfCode) ||
            (distance == 0.0f && !shape.isSigned && inside < 0.5f - kHalfCode))
            ++count;
    }
    return count;
}

}  // namespace

double safeStep(double free) noexcept {
    const double square = free * free - 0.5;
    const double near = free * std::sqrt(0.5);
    return square > 0.0 ? std::max(near, std::sqrt(square)) : near;
}

ShapeReport checkShape(const ShapeMap& shape, const ShapeCheckOptions& options) {
    const std::vector<Subject> subjects = subjectsOf(shape);
    const auto checkRange = [&](const tbb::blocked_range<std::uint64_t>& range, Tally tally) {
        for (std::uint64_t ray = range.begin(); ray != range.end(); ++ray) {
            const Subject& subject = subjects[ray % subjects.size()];
            std::optional<ShapeViolation> step = drawStep(subject, RayNumbers(options.seed, ray));
            if (!step)
                continue;
            ++tally.steps;
            tally.length += step->length * shape.width();
            if (step->depth <= kTolerance)
                continue;
            step->ray = ray;
            ++tally.violations;
            tally.offer(*step);
        }
        if (options.advance)
            options.advance(range.size());
        return tally;
    };
    // Always joined in the same order: the mean step is the same for any number of threads.
    const Tally tally = tbb::parallel_deterministic_reduce(
        tbb::blocked_range<std::uint64_t>(0, options.rays, kRaysPerTask), Tally{}, checkRange,
        [](Tally left, const Tally& right) {
            left.add(right);
            return left;
        });
    ShapeReport report{options.rays, tally.violations, tally.worst, countContradictions(shape),
                       0.0};
    if (tally.steps > 0)
        report.meanStep = tally.length / static_cast<double>(tally.steps);
    return report;
}

}  // namespace relievo::reference
