#include "viewer/reference_frame.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cassert>
#include <glm/geometric.hpp>

#include "reference/bilinear_tracer.h"
#include "reference/visibility.h"
#include "shaders/relievo/constants.h"

namespace relievo::viewer {
namespace {

// World length of one unit of t, in tile widths: |(du, ρ·dv, a·dz)|.
double lengthPerT(const MeasuredPixel& pixel, double aspect, double depthScale) {
    return glm::length(
        glm::dvec3(pixel.direction.x, aspect * pixel.direction.y, depthScale * pixel.direction.z));
}

ReferencePixel tracePixel(const MeasuredPixel& pixel, const textures::DepthMap& map,
                          const reference::TileWindow& window, double depthScale, int lightRays) {
    ReferencePixel result;
    result.covered = pixel.covered;
    if (!pixel.covered)
        return result;
    const reference::TileRay ray{glm::dvec3(pixel.origin), glm::dvec3(pixel.direction)};
    const auto hit = reference::traceBilinear(map, ray, window, RELIEVO_MAXIMUM_REACH);
    if (!hit)
        return result;
    result.hit = true;
    result.t = hit->t;
    result.position = hit->position;
    result.normal = reference::bilinearNormal(map, hit->position.x, hit->position.y, depthScale);
    if (lightRays > 0) {
        const reference::DiscLight light{glm::dvec3(pixel.light), glm::dvec3(pixel.lift),
                                         glm::dvec3(pixel.side)};
        result.lightShare = reference::visibleShare(map, glm::dvec2(hit->position), light,
                                                    lightRays, window, RELIEVO_MAXIMUM_REACH);
    }
    return result;
}

// Calls visit(pixel, place) with the place of each pixel when rows are counted from the bottom.
template <typename Visit>
void forEachFromTheBottom(const ReferenceFrame& reference, const Visit& visit) {
    const auto width = static_cast<std::size_t>(reference.width);
    const auto height = static_cast<std::size_t>(reference.height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            visit(reference.pixels[y * width + x], (height - 1 - y) * width + x);
}

}  // namespace

ReferenceFrame traceReference(const MeasuredFrame& frame, const textures::DepthMap& map,
                              const glm::vec4& window, double depthScale, int lightRays) {
    ReferenceFrame result{frame.width, frame.height, {}, lightRays};
    result.pixels.resize(frame.pixels.size());
    const reference::TileWindow tileWindow{glm::dvec2(window.x, window.y),
                                           glm::dvec2(window.z, window.w)};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, frame.pixels.size(), 1024),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t k = range.begin(); k < range.end(); ++k)
                              result.pixels[k] = tracePixel(frame.pixels[k], map, tileWindow,
                                                            depthScale, lightRays);
                      });
    return result;
}

std::vector<float> givenHitTexels(const ReferenceFrame& reference) {
    std::vector<float> texels(4 * reference.pixels.size());
    forEachFromTheBottom(reference, [&](const ReferencePixel& pixel, std::size_t place) {
        float* texel = &texels[4 * place];
        for (int axis = 0; axis < 3; ++axis)
            texel[axis] = static_cast<float>(pixel.position[axis]);
        texel[3] = pixel.hit ? static_cast<float>(pixel.t) : -1.0f;
    });
    return texels;
}

std::vector<float> givenVisibilityTexels(const ReferenceFrame& reference) {
    std::vector<float> texels(reference.pixels.size());
    forEachFromTheBottom(reference, [&](const ReferencePixel& pixel, std::size_t place) {
        texels[place] = static_cast<float>(pixel.lightShare);
    });
    return texels;
}

std::vector<reference::HitComparison> compareFrames(const MeasuredFrame& frame,
                                                    const ReferenceFrame& reference,
                                                    const textures::DepthMap& map,
                                                    double depthScale) {
    assert(frame.pixels.size() == reference.pixels.size());
    std::vector<reference::HitComparison> result;
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
        const MeasuredPixel& pixel = frame.pixels[k];
        if (!pixel.covered)
            continue;
        const ReferencePixel& exact = reference.pixels[k];
        const double length = lengthPerT(pixel, map.aspect(), depthScale);
        reference::HitComparison comparison;
        comparison.found = pixel.outcome == RELIEVO_OUTCOME_HIT;
        comparison.converged = pixel.outcome != RELIEVO_OUTCOME_EXHAUSTED;
        comparison.exists = exact.hit;
        comparison.distance = length * static_cast<double>(pixel.t);
        comparison.exactDistance = length * exact.t;
        comparison.normal = glm::dvec3(pixel.normal);
        comparison.exactNormal = exact.normal;
        result.push_back(comparison);
    }
    return result;
}

}  // namespace relievo::viewer
