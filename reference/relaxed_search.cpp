#include "reference/relaxed_search.h"

#include "reference/bisection.h"

namespace relievo::reference {

namespace {

CellWalk walkFrom(const textures::DepthMap& relief, const DescendingRay& ray, double z) {
    CellWalk walk = walkOver(relief, ray);
    walk.jump(z);
    return walk;
}

}  // namespace

MapSearchResult searchByRelaxedCones(const textures::DepthMap& relief, const textures::Plane& ratio,
                                     const DescendingRay& ray, int bisections,
                                     const SearchEnd& end) {
    const ConeMarch march = marchByCones(relief, ratio, ray, end);
    if (!march.converged || march.gap >= 0.0)
        return {march.z, march.converged, march.lookups};
    Bracket bracket{march.before, march.z};
    for (int k = 0; k < bisections; ++k)
        halve(relief, ray, bracket);
    return {bracket.below, true, march.lookups + bisections};
}

MapSearchResult searchByRelaxedConesAndCells(const textures::DepthMap& relief,
                                             const textures::Plane& ratio, const DescendingRay& ray,
                                             const SearchEnd& end) {
    const ConeMarch march = marchByCones(relief, ratio, ray, end);
    MapSearchResult result{march.z, march.converged, march.lookups};
    if (!march.converged)
        return result;
    Bracket bracket{march.gap < 0.0 ? march.before : march.z, march.z};
    CellWalk walk = walkFrom(relief, ray, bracket.above);
    // Doubles end the halving of a ray that crosses a border within their resolution.
    while (walk.isBeyond(bracket.below) && bracket.below - bracket.above > 1e-15) {
        halve(relief, ray, bracket);
        ++result.lookups;
        walk = walkFrom(relief, ray, bracket.above);
    }
    for (;; walk.step()) {
        ++result.lookups;
        if (const std::optional<double> hit = hitInCell(walk)) {
            result.z = *hit;
            return result;
        }
        if (walk.isLast())
            return result;
    }
}

}  // namespace relievo::reference
