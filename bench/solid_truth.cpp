#include "bench/solid_truth.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "shaders/relievo/constants.h"

namespace relievo::bench {
namespace {

double lengthPerT(const viewer::MeasuredPixel& pixel, const SolidSpace& space) {
    return glm::length(glm::dvec3(pixel.direction) *
                       glm::dvec3(1.0, space.aspect, space.depthScale));
}

FirstHit traceRay(const viewer::MeasuredPixel& pixel, const solids::SolidTracer& tracer,
                  const SolidSpace& space) {
    const glm::dvec3 origin(pixel.origin);
    const glm::dvec3 direction(pixel.direction);
    const double length = lengthPerT(pixel, space);
    if (const auto hit = tracer.firstHit({origin, direction}))
        return {true, false, length * hit->t};
    if (space.hasFloor && direction.z > 0.0)
        return {true, true, length * (1.0 - origin.z) / direction.z};
    return {};
}

solids::SolidTracer tracerOf(solids::SolidPart part, double growth) {
    part.solid.extension += growth;
    for (solids::ProfilePiece& piece : part.solid.profile.pieces) {
        piece.topOffset += growth;
        piece.bottomOffset += growth;
    }
    return solids::SolidTracer({{std::move(part)}});
}

// What a search says of a ray.
struct FoundHit {
    bool isFound = false;
    bool isFloor = false;
    double distance = 0.0;
};

bool agree(const FoundHit& found, const FirstHit& truth, double tolerance) {
    return found.isFound == truth.exists &&
           (!truth.exists || std::abs(found.distance - truth.distance) <= tolerance);
}

// The hit that a search is measured against.
const FirstHit& referenceOf(const FoundHit& found, const RayTruth& truth, double tolerance) {
    if (!agree(found, truth.exact, tolerance))
        for (const FirstHit& tied : truth.tied)
            if (agree(found, tied, tolerance))
                return tied;
    return truth.exact;
}

struct FaultCounts {
    std::size_t behind = 0;
    std::size_t lost = 0;
    std::size_t inFront = 0;

    void add(const FoundHit& found, const FirstHit& first, double tolerance) {
        const double off = found.distance - first.distance;
        if (!found.isFound || (first.exists && found.isFloor && off > tolerance))
            lost += first.exists && !first.isFloor ? 1 : 0;
        else if (!first.exists || off < -tolerance)
            ++inFront;
        else if (off > tolerance)
            ++behind;
    }
};

}  // namespace

SolidTruth::SolidTruth(const solids::SolidPart& part)
    : tracers_{tracerOf(part, 0.0), tracerOf(part, kSolidTie / part.solid.shape->width()),
               tracerOf(part, -kSolidTie / part.solid.shape->width())} {}

std::vector<RayTruth> SolidTruth::trace(const viewer::MeasuredFrame& frame,
                                        const SolidSpace& space) const {
    std::vector<RayTruth> truth(frame.pixels.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, truth.size(), 1024),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t k = range.begin(); k < range.end(); ++k) {
                              const viewer::MeasuredPixel& pixel = frame.pixels[k];
                              if (!pixel.covered)
                                  continue;
                              truth[k].exact = traceRay(pixel, tracers_[0], space);
                              truth[k].tied = {traceRay(pixel, tracers_[1], space),
                                               traceRay(pixel, tracers_[2], space)};
                          }
                      });
    return truth;
}

SolidErrors compareWithSolid(const viewer::MeasuredFrame& frame, const std::vector<RayTruth>& truth,
                             const SolidSpace& space, double tolerance) {
    assert(frame.pixels.size() == truth.size());
    constexpr float kFloor = 1.0f - 1e-4f;
    std::vector<reference::HitComparison> comparisons;
    FaultCounts counts;
    std::size_t tied = 0;
    for (std::size_t k = 0; k < truth.size(); ++k) {
        const viewer::MeasuredPixel& pixel = frame.pixels[k];
        if (!pixel.covered)
            continue;
        const FoundHit found{pixel.outcome == RELIEVO_OUTCOME_HIT,
                             space.hasFloor && pixel.hit.z >= kFloor,
                             lengthPerT(pixel, space) * double{pixel.t}};
        const bool converged = pixel.outcome != RELIEVO_OUTCOME_EXHAUSTED;
        const FirstHit& first =
            converged ? referenceOf(found, truth[k], tolerance) : truth[k].exact;
        tied += &first == &truth[k].exact ? 0 : 1;
        if (converged)
            counts.add(found, first, tolerance);
        reference::HitComparison ray;
        ray.found = found.isFound;
        ray.converged = converged;
        ray.exists = first.exists;
        ray.distance = found.distance;
        ray.exactDistance = first.distance;
        comparisons.push_back(ray);
    }
    const double rays = std::max(1.0, static_cast<double>(comparisons.size()));
    const auto share = [rays](std::size_t count) { return static_cast<double>(count) / rays; };
    return {reference::summarizeErrors(comparisons, tolerance),
            {share(counts.behind), share(counts.lost), share(counts.inFront)},
            share(tied)};
}

}  // namespace relievo::bench
