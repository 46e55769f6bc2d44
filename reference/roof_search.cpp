#include "reference/roof_search.h"

#include <algorithm>

namespace relievo::reference {

namespace {

// How deep the ray may go on from depth z above the roof of the walk's cell.
double freeDepth(const CellWalk& walk, const RoofCone& cone, const DescendingRay& ray,
                 const textures::DepthMap& relief, int block) {
    const double z = walk.entry();
    const double speed = ray.speed(relief.aspect());
    const double byCone = cone.ratio > 0.0 ? z + (cone.roof - z) / (speed / cone.ratio + 1.0) : z;
    const glm::dvec2 size(relief.width(), relief.height());
    const double exit = blockExit(ray.start * size - 0.5, ray.slope * size, walk.columns().cell(),
                                  walk.rows().cell(), block);
    return std::max(byCone, std::min(cone.roof, exit));
}

}  // namespace

MapSearchResult searchByRoofs(const textures::DepthMap& relief, const RoofMap& roofs,
                              const DescendingRay& ray) {
    MapSearchResult result;
    for (CellWalk walk = walkOver(relief, ray);;) {
        const RoofCone cone =
            roofConeAt(roofs, relief, walk.columns().cell(), walk.rows().cell(), ray.slope);
        ++result.lookups;
        if (walk.entry() < cone.roof) {
            const double next = freeDepth(walk, cone, ray, relief, roofs.block);
            if (walk.isBeyond(next)) {
                walk.jump(std::min(next, 1.0));
                continue;
            }
        }
        ++result.lookups;
        if (const std::optional<double> hit = hitInCell(walk)) {
            result.z = *hit;
            return result;
        }
        if (walk.isLast())
            return result;
        walk.step();
    }
}

}  // namespace relievo::reference
