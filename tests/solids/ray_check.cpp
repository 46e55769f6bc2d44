#include "ray_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "small_shapes.h"

namespace relievo::solids {
namespace {

constexpr double kLeastClearance = 1e-11;
constexpr double kBorder = 1e-9;

class Comparison {
  public:
    Comparison(const SolidPart& part, const std::vector<SolidCrossing>& crossings,
               const SolidRay& ray)
        : part_(part), crossings_(crossings), ray_(ray) {}

    [[nodiscard]] glm::dvec3 place(double t) const {
        return glm::dvec3(part_.fromWhole * glm::dvec4(ray_.origin + t * ray_.direction, 1.0));
    }

    [[nodiscard]] bool listedInside(double t) const {
        bool isInside = false;
        for (const SolidCrossing& crossing : crossings_)
            if (crossing.t <= t)
                isInside = crossing.enters;
        return isInside;
    }

    [[nodiscard]] std::optional<std::string> check(double t) const {
        const bool listed = listedInside(t);
        const glm::dvec3 p = place(t);
        const bool plain = plainInside(part_, ray_.origin + t * ray_.direction);
        if (listed == plain || isTie(part_, p))
            return std::nullopt;
        return fmt::format("at t = {}, ({}, {}, {}): {} by the crossings, d - o = {}", t, p.x, p.y,
                           p.z, listed ? "inside" : "outside", plainClearance(part_.solid, p));
    }

    // Looks for the minimum of sign·(d − o) between a and b and checks it.
    [[nodiscard]] std::optional<std::string> checkMinimum(double a, double b, double sign) const {
        for (int k = 0; k < 40; ++k) {
            const double third = (b - a) / 3.0;
            const double left = sign * plainClearance(part_.solid, place(a + third));
            const double right = sign * plainClearance(part_.solid, place(b - third));
            (left < right ? b : a) = left < right ? b - third : a + third;
        }
        return check(0.5 * (a + b));
    }

  private:
    const SolidPart& part_;
    const std::vector<SolidCrossing>& crossings_;
    const SolidRay& ray_;
};

}  // namespace

bool isTie(const SolidPart& part, const glm::dvec3& place) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(place[axis] - part.windowMinimum[axis]) < kBorder ||
            std::abs(place[axis] - part.windowMaximum[axis]) < kBorder)
            return true;
        if (part.solid.kind == SolidKind::Revolution &&
            std::abs(place[axis] - std::round(place[axis])) < kBorder)
            return true;
    }
    if (part.solid.kind == SolidKind::Extrusion)
        for (const ProfilePiece& piece : part.solid.profile.pieces)
            if (std::abs(place.z - piece.bottom) < kBorder)
                return true;
    return std::abs(plainClearance(part.solid, place)) < kLeastClearance;
}

std::optional<std::string> disagreement(const SolidPart& part,
                                        const std::vector<SolidCrossing>& crossings,
                                        const SolidRay& ray, double end, int samples) {
    const Comparison comparison(part, crossings, ray);
    std::vector<double> places;
    for (int k = 0; k <= samples; ++k)
        places.push_back(end * k / samples);
    for (std::size_t k = 0; k < crossings.size(); ++k) {
        const SolidCrossing& crossing = crossings[k];
        if (crossing.enters != (k % 2 == 0))
            return fmt::format("crossing {} does not alternate", k);
        if (k > 0 && crossing.t < crossings[k - 1].t)
            return fmt::format("crossing {} at {} comes before its predecessor", k, crossing.t);
        if (!std::isfinite(crossing.t) || crossing.t < 0.0)
            return fmt::format("crossing {} at {}", k, crossing.t);
        // Out of the solid: against the ray where it goes in.
        const double along = glm::dot(crossing.outward, ray.direction);
        const double size = glm::length(crossing.outward) * glm::length(ray.direction);
        if (!(crossing.enters ? along <= 1e-6 * size : along >= -1e-6 * size))
            return fmt::format("crossing {} at {}: outward points the wrong way, {}", k, crossing.t,
                               along);
        const double next = k + 1 < crossings.size() ? crossings[k + 1].t : end;
        places.push_back(0.5 * (crossing.t + next));
        const double shift = 1e-8 / std::max(1e-300, glm::length(ray.direction));
        if (next - crossing.t > 2.0 * shift) {
            places.push_back(crossing.t + shift);
            places.push_back(next - shift);
        }
    }
    for (const double t : places)
        if (auto wrong = comparison.check(t))
            return wrong;
    std::vector<double> clearances;
    for (int k = 0; k <= samples; ++k)
        clearances.push_back(plainClearance(part.solid, comparison.place(end * k / samples)));
    for (int k = 1; k < samples; ++k) {
        const auto* here = &clearances[static_cast<std::size_t>(k)];
        const double sign = *here > 0.0 ? 1.0 : -1.0;
        if (sign * here[-1] >= sign * here[0] && sign * here[1] >= sign * here[0])
            if (auto wrong =
                    comparison.checkMinimum(end * (k - 1) / samples, end * (k + 1) / samples, sign))
                return wrong;
    }
    return std::nullopt;
}

SolidRay randomRay(const glm::dvec3& low, const glm::dvec3& high, std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    const double margin = unit(random) < 0.25 ? 0.0 : 1.0;
    SolidRay ray;
    for (int axis = 0; axis < 3; ++axis)
        ray.origin[axis] =
            low[axis] - margin + (high[axis] - low[axis] + 2.0 * margin) * unit(random);
    glm::dvec3 target;
    for (int axis = 0; axis < 3; ++axis)
        target[axis] = low[axis] + (high[axis] - low[axis]) * unit(random);
    ray.direction = target - ray.origin;
    const double kind = unit(random);
    const int axis = static_cast<int>(3.0 * unit(random));
    if (kind < 0.125) {
        const double component = ray.direction[axis];
        ray.direction = glm::dvec3(0.0);
        ray.direction[axis] = component;
    } else if (kind < 0.25) {
        ray.direction[axis] = 0.0;
    } else if (kind < 0.375) {
        ray.direction[axis] *= 1e-3 * normal(random);  // grazing
    }
    ray.direction *=
        std::pow(10.0, 6.0 * unit(random) - 3.0) / std::max(1e-3, glm::length(ray.direction));
    return ray;
}

double lastPlace(const SolidRay& ray, const glm::dvec3& low, const glm::dvec3& high) {
    double last = 1e30;
    for (int axis = 0; axis < 3; ++axis)
        if (ray.direction[axis] != 0.0)
            last = std::min(last, std::max((low[axis] - ray.origin[axis]) / ray.direction[axis],
                                           (high[axis] - ray.origin[axis]) / ray.direction[axis]));
    return last < 1e30 ? std::max(0.0, last) : 0.0;
}

}  // namespace relievo::solids
