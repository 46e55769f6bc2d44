#include "bench/technique_maps.h"

#include <utility>

#include "materials/relief_maps.h"

namespace relievo::bench {

preprocess::ReliefPlan planFor(const materials::Technique& technique,
                               const materials::ShadowMethod* shadow) {
    std::vector<std::string_view> maps(technique.maps.begin(), technique.maps.end());
    if (shadow)
        maps.insert(maps.end(), shadow->maps.begin(), shadow->maps.end());
    materials::BakeWords words = materials::bakeWordsFor(maps);
    preprocess::ReliefPlan plan;
    plan.maps = std::move(words.maps);
    if (!words.cones.empty())
        plan.cone = std::move(words.cones);
    // Displacements over a plane base are all that is read, and packing would leave those of eight
    // elevations as large as they are.
    plan.views.curvatures = 1;
    plan.terms = 0;
    return plan;
}

}  // namespace relievo::bench
