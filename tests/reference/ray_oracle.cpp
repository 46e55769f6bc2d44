#include "ray_oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "textures/bilinear.h"

namespace relievo::reference::test {

namespace {

double horizontalSpeed(const textures::DepthMap& map, const TileRay& ray) {
    return std::hypot(ray.direction.x * map.width(), ray.direction.y * map.height());
}

glm::dvec3 pointAt(const TileRay& ray, double t) {
    return ray.origin + t * ray.direction;
}

/// Parameters from begin to end, close enough together for the ray to move at most
/// 1/samplesPerTexel texels, or a thousandth of the depth, at a time.
std::vector<double> denseParameters(const textures::DepthMap& map, const TileRay& ray,
                                    const RaySpan& span, double samplesPerTexel) {
    const double length = span.end - span.begin;
    const double texels = length * horizontalSpeed(map, ray);
    const double depth = length * std::abs(ray.direction.z);
    const double count = std::ceil(std::max(texels * samplesPerTexel, depth * 1000.0));
    const auto n = static_cast<int>(std::clamp(count, 1.0, 1e6));
    std::vector<double> parameters;
    for (int k = 0; k <= n; ++k)
        parameters.push_back(span.begin + length * k / n);
    return parameters;
}

double bisect(const textures::DepthMap& map, const TileRay& ray, double above, double below) {
    for (int k = 0; k < 80; ++k) {
        const double middle = 0.5 * (above + below);
        (depthBelow(map, ray, middle) >= 0.0 ? below : above) = middle;
    }
    return below;
}

std::optional<double> firstBelow(const textures::DepthMap& map, const TileRay& ray,
                                 const std::vector<double>& parameters) {
    for (std::size_t k = 0; k < parameters.size(); ++k)
        if (depthBelow(map, ray, parameters[k]) >= 0.0)
            return k == 0 ? parameters[0] : bisect(map, ray, parameters[k - 1], parameters[k]);
    return std::nullopt;
}

std::optional<TileHit> hitAt(const TileRay& ray, std::optional<double> t) {
    if (!t)
        return std::nullopt;
    return TileHit{*t, pointAt(ray, *t), false};
}

void addCrossings(double origin, double speed, const RaySpan& span, std::vector<double>& out) {
    if (speed == 0.0)
        return;
    const double a = origin + span.begin * speed;
    const double b = origin + span.end * speed;
    for (double k = std::ceil(std::min(a, b)); k <= std::max(a, b); k += 1.0)
        out.push_back((k - origin) / speed);
}

}  // namespace

double depthBelow(const textures::DepthMap& map, const TileRay& ray, double t) {
    const glm::dvec3 p = pointAt(ray, t);
    return p.z - textures::sampleBilinear(map.depth, p.x, p.y, map.wrap);
}

std::optional<RaySpan> spanInWindow(const textures::DepthMap& map, const TileRay& ray,
                                    const TileWindow& window, double maxDistance) {
    const double horizontal = std::hypot(ray.direction.x, map.aspect() * ray.direction.y);
    RaySpan span{0.0, 1e300};
    const auto cut = [&](double origin, double speed, double low, double high) {
        if (speed == 0.0)
            return origin >= low && origin <= high;
        const auto [near, far] = std::minmax({(low - origin) / speed, (high - origin) / speed});
        span = {std::max(span.begin, near), std::min(span.end, far)};
        return span.begin <= span.end;
    };
    if (!cut(ray.origin.x, ray.direction.x, window.minimum.x, window.maximum.x) ||
        !cut(ray.origin.y, ray.direction.y, window.minimum.y, window.maximum.y) ||
        !cut(ray.origin.z, ray.direction.z, 0.0, 1.0))
        return std::nullopt;
    if (horizontal > 0.0)
        span.end = std::min(span.end, span.begin + maxDistance / horizontal);
    if (span.end == 1e300)  // a ray that stands still
        span.end = span.begin;
    return span;
}

std::optional<std::string> violation(const textures::DepthMap& map, const TileRay& ray,
                                     const TileWindow& window, const std::optional<TileHit>& hit,
                                     double maxDistance, double samplesPerTexel) {
    // The surface may be as steep as 1 per texel and coordinates are rounded: see the callers.
    constexpr double kOnSurface = 1e-11;
    const std::optional<RaySpan> span = spanInWindow(map, ray, window, maxDistance);
    if (!span)
        return hit ? std::optional<std::string>("a hit outside the window") : std::nullopt;
    if (hit) {
        if (hit->t < span->begin - 1e-12 || hit->t > span->end + 1e-9)
            return fmt::format("hit at {} outside [{}, {}]", hit->t, span->begin, span->end);
        if (glm::length(hit->position - pointAt(ray, hit->t)) > 1e-11)
            return "the position is not on the ray";
        const double below = hit->position.z - textures::sampleBilinear(map.depth, hit->position.x,
                                                                        hit->position.y, map.wrap);
        if (hit->startsInside)
            return below > 0.0 && std::abs(hit->t - span->begin) < 1e-12
                       ? std::nullopt
                       : std::optional(fmt::format("says inside, {} below at {}", below, hit->t));
        if (std::abs(below) > kOnSurface)
            return fmt::format("hit {} below the surface", below);
    }
    const double end = hit ? hit->t : span->end;
    for (const double t : denseParameters(map, ray, {span->begin, end}, samplesPerTexel))
        if (const double below = depthBelow(map, ray, t); below > 1e-9)
            return fmt::format("{} below the surface at {}, before {}", below, t, end);
    return std::nullopt;
}

std::optional<double> marchToHit(const textures::DepthMap& map, const TileRay& ray,
                                 const TileWindow& window, double maxDistance,
                                 double samplesPerTexel) {
    const std::optional<RaySpan> span = spanInWindow(map, ray, window, maxDistance);
    if (!span)
        return std::nullopt;
    return firstBelow(map, ray, denseParameters(map, ray, *span, samplesPerTexel));
}

std::optional<TileHit> traceCellBordersOnly(const textures::DepthMap& map, const TileRay& ray,
                                            const TileWindow& window, double maxDistance) {
    const std::optional<RaySpan> span = spanInWindow(map, ray, window, maxDistance);
    if (!span)
        return std::nullopt;
    std::vector<double> borders{span->begin, span->end};
    addCrossings(ray.origin.x * map.width() - 0.5, ray.direction.x * map.width(), *span, borders);
    addCrossings(ray.origin.y * map.height() - 0.5, ray.direction.y * map.height(), *span, borders);
    std::sort(borders.begin(), borders.end());
    return hitAt(ray, firstBelow(map, ray, borders));
}

std::optional<TileHit> traceSkippingCells(const textures::DepthMap& map, const TileRay& ray,
                                          const TileWindow& window, double maxDistance) {
    const std::optional<RaySpan> span = spanInWindow(map, ray, window, maxDistance);
    if (!span)
        return std::nullopt;
    const double step = 1.0 / std::max(horizontalSpeed(map, ray), 1e-6);
    std::vector<double> parameters;
    for (double t = span->begin; t < span->end; t += step)
        parameters.push_back(t);
    parameters.push_back(span->end);
    return hitAt(ray, firstBelow(map, ray, parameters));
}

}  // namespace relievo::reference::test
