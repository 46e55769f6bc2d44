#include "bench/technique_maps.h"

#include "materials/relief_maps.h"

namespace relievo::bench {

preprocess::ReliefPlan planFor(const materials::Technique& technique) {
    preprocess::ReliefPlan plan;
    plan.maps = {"depth", "derivative"};
    for (const std::string_view name : technique.maps) {
        const materials::ReliefMapFormat& format = materials::reliefMapFormat(name);
        if (!format.cones.empty()) {
            plan.maps.emplace_back("cone");
            plan.cone = format.cones;
        } else if (format.form != materials::ReliefMapForm::Pyramid && !plan.has(name)) {
            plan.maps.emplace_back(name);
        }
    }
    return plan;
}

}  // namespace relievo::bench
