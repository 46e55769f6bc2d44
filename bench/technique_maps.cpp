#include "bench/technique_maps.h"

#include <utility>

#include "materials/relief_maps.h"

namespace relievo::bench {

preprocess::ReliefPlan planFor(const materials::Technique& technique) {
    materials::BakeWords words = materials::bakeWordsFor(technique.maps);
    preprocess::ReliefPlan plan;
    plan.maps = std::move(words.maps);
    if (!words.cones.empty())
        plan.cone = std::move(words.cones);
    return plan;
}

}  // namespace relievo::bench
