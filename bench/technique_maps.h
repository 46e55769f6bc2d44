#pragma once

#include "materials/shadow_registry.h"
#include "materials/technique_registry.h"
#include "preprocess/relief_plan.h"

namespace relievo::bench {

/// What to bake of a relief so that `technique` can be drawn: the maps of its search, with the kind
/// of cones that it takes, those of the shading, and those of the shadow method, if there is one.
preprocess::ReliefPlan planFor(const materials::Technique& technique,
                               const materials::ShadowMethod* shadow = nullptr);

}  // namespace relievo::bench
