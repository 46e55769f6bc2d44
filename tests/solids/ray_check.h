#pragma once

#include <optional>
#include <random>
#include <string>

#include "solids/solid_tracer.h"

namespace relievo::solids {

/// Whether rounding decides about a place of the part's tile space: |d − o| under 1e-11, or a
/// border of the window, of a replica or of a piece of the profile within 1e-9.
bool isTie(const SolidPart& part, const glm::dvec3& place);

/// Compares the crossings of a ray with one part with the implicit function itself, evaluated in
/// another way, at `samples` places between 0 and `end`, between the crossings, and at the minima
/// of its size that those hint at. Nothing if all agree, else what does not. Places count unless
/// the function is under 1e-11 there, or they are within 1e-9 of a border.
std::optional<std::string> disagreement(const SolidPart& part,
                                        const std::vector<SolidCrossing>& crossings,
                                        const SolidRay& ray, double end, int samples);

/// A ray of random direction from around the box [low − 1, high + 1], one time in four inside it,
/// one in eight along an axis, one in eight with a component of exactly 0, lengths from 1e-3 to
/// 1e3.
SolidRay randomRay(const glm::dvec3& low, const glm::dvec3& high, std::mt19937_64& random);

/// The largest t at which the ray is in the box around its part (the whole's space being the
/// part's), at least 0 and finite.
double lastPlace(const SolidRay& ray, const glm::dvec3& low, const glm::dvec3& high);

}  // namespace relievo::solids
