#include "viewer/solid_errors.h"

#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

#include "shaders/relievo/constants.h"
#include "solids/solid_tracer.h"

namespace relievo::viewer {
namespace {

reference::HitComparison compare(const MeasuredPixel& pixel, const solids::SolidTracer& tracer,
                                 const SolidMetric& metric) {
    const glm::dvec3 origin(pixel.origin);
    const glm::dvec3 direction(pixel.direction);
    const double length = glm::length(direction * metric.texels);
    reference::HitComparison ray;
    ray.found = pixel.outcome == RELIEVO_OUTCOME_HIT;
    ray.converged = pixel.outcome != RELIEVO_OUTCOME_EXHAUSTED;
    ray.distance = length * static_cast<double>(pixel.t);
    if (const auto hit = tracer.firstHit({origin, direction})) {
        ray.exists = true;
        ray.exactDistance = length * hit->t;
    } else if (metric.hasFloor && direction.z > 0.0) {
        // The floor goes as far as the window, where the ray ends.
        ray.exists = origin.z + static_cast<double>(pixel.end) * direction.z >= 1.0 - 1e-5;
        ray.exactDistance = length * (1.0 - origin.z) / direction.z;
    }
    return ray;
}

PixelVerdict verdictOf(const reference::HitComparison& ray) {
    if (!ray.converged)
        return PixelVerdict::Exhausted;
    return ray.found == ray.exists ? PixelVerdict::Compared : PixelVerdict::Mismatch;
}

}  // namespace

SolidErrors measureSolidErrors(const MeasuredFrame& frame, const solids::Compound& compound,
                               const SolidMetric& metric) {
    const solids::SolidTracer tracer(compound);
    std::vector<reference::HitComparison> rays(frame.pixels.size());
    tbb::parallel_for(std::size_t{0}, rays.size(), [&](std::size_t k) {
        if (frame.pixels[k].covered)
            rays[k] = compare(frame.pixels[k], tracer, metric);
    });
    const textures::Plane empty(frame.width, frame.height);
    SolidErrors errors{{empty, {}, empty, empty, empty}, {}};
    std::vector<reference::HitComparison> covered;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const MeasuredPixel& pixel = frame.pixels[k];
        const reference::HitComparison& ray = rays[k];
        const PixelVerdict verdict = pixel.covered ? verdictOf(ray) : PixelVerdict::Uncovered;
        if (pixel.covered)
            covered.push_back(ray);
        if (verdict == PixelVerdict::Compared && ray.exists)
            errors.image.distance.texels[k] = static_cast<float>(ray.distance - ray.exactDistance);
        errors.image.verdict.texels[k] = static_cast<float>(static_cast<int>(verdict));
        errors.image.steps.texels[k] = static_cast<float>(pixel.steps);
        errors.image.fetches.texels[k] = static_cast<float>(pixel.fetches);
    }
    errors.statistics = reference::summarizeErrors(covered, 1.0);
    return errors;
}

std::vector<NamedPlane> namedPlanes(const SolidErrors& errors, const std::string& prefix) {
    return {{prefix + ".distance", errors.image.distance},
            {prefix + ".verdict", errors.image.verdict},
            {prefix + ".steps", errors.image.steps},
            {prefix + ".fetches", errors.image.fetches}};
}

}  // namespace relievo::viewer
