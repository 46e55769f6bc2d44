#include "reference/guarantee_check.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "reference/adversarial_rays.h"
#include "reference/ray_sector.h"
#include "reference/roof_map.h"
#include "reference/surface_crossings.h"
#include "textures/bilinear.h"
#include "textures/storage_format.h"

namespace relievo::reference {

namespace {

using textures::DepthMap;
using textures::Plane;

constexpr std::size_t kRaysPerTask = 4096;
constexpr double kLongestStepInTiles = 2.0;

// What a map says about one ray: the step that it allows.
struct AllowedStep {
    TileRay ray;
    double length = 0.0;
    int i = 0;
    int j = 0;
};

struct Tally {
    std::uint64_t violations = 0;
    std::optional<GuaranteeViolation> worst;

    // The same whatever the order: of equally bad steps the first drawn counts.
    void offer(const GuaranteeViolation& other) {
        if (!worst || other.depth > worst->depth ||
            (other.depth == worst->depth && other.ray < worst->ray))
            worst = other;
    }
    void add(const Tally& other) {
        violations += other.violations;
        if (other.worst)
            offer(*other.worst);
    }
};

// The distance along a ray with a direction of metric length 1 to where it leaves the cone of
// `ratio` whose apex is `gap` below its start: cos·t = ratio·(gap − sin·t).
double coneStep(const DepthMap& relief, const glm::dvec3& direction, double ratio, double gap) {
    const double horizontal = std::hypot(direction.x, relief.aspect() * direction.y);
    const double closing = horizontal / ratio + direction.z;
    const double longest = kLongestStepInTiles * std::max(1.0, relief.aspect()) / horizontal;
    return ratio > 0.0 ? std::min(gap / closing, longest) : 0.0;
}

std::optional<AllowedStep> drawConeStep(const DepthMap& relief, std::span<const Plane> ratios,
                                        RayNumbers numbers) {
    const glm::dvec2 place = drawPlace(relief, numbers);
    const double depth = textures::sampleBilinear(relief.depth, place.x, place.y, relief.wrap);
    const Heading heading = drawHeading(relief, place, depth, numbers);
    const std::optional<TileRay> ray = drawRay(place, depth, heading, numbers);
    if (!ray)
        return std::nullopt;
    const int i = std::min(static_cast<int>(place.x * relief.width()), relief.width() - 1);
    const int j = std::min(static_cast<int>(place.y * relief.height()), relief.height() - 1);
    const int sector = raySector(ray->direction, relief.aspect(), static_cast<int>(ratios.size()));
    const double ratio = ratios[static_cast<std::size_t>(sector)].at(i, j);
    const double length = coneStep(relief, ray->direction, ratio, depth - ray->origin.z);
    return AllowedStep{*ray, length, i, j};
}

// Cells have their corners at texel centres: half a texel from where squares have theirs.
glm::dvec2 drawPlaceInCell(const DepthMap& relief, RayNumbers& numbers) {
    const glm::dvec2 place =
        drawPlace(relief, numbers) + 0.5 / glm::dvec2(relief.width(), relief.height());
    return place - glm::floor(place);
}

std::optional<AllowedStep> drawRoofStep(const DepthMap& relief, const RoofMap& roofs,
                                        RayNumbers numbers) {
    const glm::dvec2 size(relief.width(), relief.height());
    const glm::dvec2 place = drawPlaceInCell(relief, numbers);
    const double depth = textures::sampleBilinear(relief.depth, place.x, place.y, relief.wrap);
    const Heading heading = drawHeading(relief, place, depth, numbers);
    const glm::dvec2 texels = place * size - 0.5;
    const auto column = static_cast<std::int64_t>(std::floor(texels.x));
    const auto row = static_cast<std::int64_t>(std::floor(texels.y));
    const RoofCone cone = roofConeAt(roofs, relief, column, row, heading.direction);
    const std::optional<TileRay> ray = drawRay(place, std::min(cone.roof, depth), heading, numbers);
    if (!ray)
        return std::nullopt;
    const glm::dvec3& direction = ray->direction;
    const double gap = cone.roof - ray->origin.z;
    const double byCone = coneStep(relief, direction, cone.ratio, gap);
    const double byBlock =
        std::min(coneStep(relief, direction, std::numeric_limits<double>::infinity(), gap),
                 blockExit(texels, glm::dvec2(direction) * size, column, row, roofs.block));
    return AllowedStep{*ray, std::max(byCone, byBlock), cone.i, cone.j};
}

// The part of a step before the ray reaches the highest point of the relief is free without a look.
struct FreeStart {
    TileRay rest;
    double length;
};

FreeStart skipToHighest(const AllowedStep& step, double leastDepth) {
    const double above = leastDepth - step.ray.origin.z;
    if (above <= 0.0)
        return {step.ray, 0.0};
    const double free = std::min(above / step.ray.direction.z, step.length);
    return {{step.ray.origin + free * step.ray.direction, step.ray.direction}, free};
}

// How far a step breaks the promise, in depth.
Excursion breach(const DepthMap& relief, const AllowedStep& step, ConePromise promise,
                 double leastDepth) {
    const FreeStart start = skipToHighest(step, leastDepth);
    const double rest = step.length - start.length;
    if (!(rest > 0.0))
        return {};
    Excursion excursion = promise == ConePromise::Conservative
                              ? deepestBelow(relief, start.rest, rest)
                              : farthestReappearance(relief, start.rest, rest);
    excursion.t += start.length;
    return excursion;
}

GuaranteeReport reportOn(const Tally& tally, std::uint64_t rays,
                         std::span<const Plane* const> ratios) {
    GuaranteeReport report{rays, tally.violations, tally.worst, 0.0, 0};
    double sum = 0.0;
    std::uint64_t limited = 0;
    for (const Plane* ratio : ratios)
        for (const float value : ratio->texels)
            if (value >= textures::kLargestHalf) {
                ++report.unlimited;
            } else {
                sum += static_cast<double>(value);
                ++limited;
            }
    report.meanRatio = limited > 0 ? sum / static_cast<double>(limited) : 0.0;
    return report;
}

// `draw` gives the step of the ray with these numbers, or nothing.
template <class Draw>
Tally checkSteps(const DepthMap& relief, ConePromise promise, const GuaranteeCheckOptions& options,
                 const Draw& draw) {
    const auto least = std::min_element(relief.depth.texels.begin(), relief.depth.texels.end());
    const double leastDepth = *least;
    const auto checkRange = [&](const tbb::blocked_range<std::uint64_t>& range, Tally tally) {
        for (std::uint64_t ray = range.begin(); ray != range.end(); ++ray) {
            const std::optional<AllowedStep> step = draw(RayNumbers(options.seed, ray));
            if (!step)
                continue;
            const Excursion off = breach(relief, *step, promise, leastDepth);
            if (off.depth <= kPiercingDepth)
                continue;
            ++tally.violations;
            tally.offer({ray, step->i, step->j, step->ray, step->length, off.t, off.depth});
        }
        if (options.advance)
            options.advance(range.size());
        return tally;
    };
    return tbb::parallel_reduce(tbb::blocked_range<std::uint64_t>(0, options.rays, kRaysPerTask),
                                Tally{}, checkRange, [](Tally left, const Tally& right) {
                                    left.add(right);
                                    return left;
                                });
}

}  // namespace

GuaranteeReport checkCones(const DepthMap& relief, std::span<const Plane> ratios,
                           ConePromise promise, const GuaranteeCheckOptions& options) {
    assert(relief.width() > 0 && relief.height() > 0);
    assert(ratios.size() == 1 || ratios.size() == 4 || ratios.size() == 8);
    const Tally tally = checkSteps(relief, promise, options, [&](RayNumbers numbers) {
        return drawConeStep(relief, ratios, numbers);
    });
    std::vector<const Plane*> planes;
    for (const Plane& ratio : ratios) {
        assert(ratio.width == relief.width() && ratio.height == relief.height());
        planes.push_back(&ratio);
    }
    return reportOn(tally, options.rays, planes);
}

GuaranteeReport checkRoofs(const DepthMap& relief, const RoofMap& roofs,
                           const GuaranteeCheckOptions& options) {
    assert(relief.width() > 0 && relief.height() > 0);
    assert(roofs.layers.size() == 1 || roofs.layers.size() == 4 || roofs.layers.size() == 8);
    const Tally tally =
        checkSteps(relief, ConePromise::Conservative, options,
                   [&](RayNumbers numbers) { return drawRoofStep(relief, roofs, numbers); });
    std::vector<const Plane*> ratios;
    for (const RoofLayer& layer : roofs.layers)
        ratios.push_back(&layer.ratio);
    return reportOn(tally, options.rays, ratios);
}

}  // namespace relievo::reference
