#pragma once

#include "materials/technique_registry.h"
#include "preprocess/relief_plan.h"

namespace relievo::bench {

/// What to bake of a relief so that `technique` can be drawn: the maps of its search, with the kind
/// of cones that it takes, and those of the shading.
preprocess::ReliefPlan planFor(const materials::Technique& technique);

}  // namespace relievo::bench
