#include "reference/cone_search.h"

#include <algorithm>
#include <limits>

#include "textures/bilinear.h"

namespace relievo::reference {

namespace {

// The length in depth of the step that leaves a cone with its apex `gap` below.
double coneStep(double ratio, double gap, double speed) {
    return ratio > 0.0 ? gap / (speed / ratio + 1.0) : 0.0;
}

}  // namespace

ConeMarch marchByCones(const textures::DepthMap& relief, const textures::Plane& ratio,
                       const DescendingRay& ray, const SearchEnd& end) {
    const double speed = ray.speed(relief.aspect());
    ConeMarch march;
    for (int step = 0; step < end.mostSteps; ++step) {
        const glm::dvec2 place = ray.at(march.z);
        ++march.lookups;
        march.gap = textures::sampleBilinear(relief.depth, place.x, place.y, relief.wrap) - march.z;
        if (march.gap <= end.tolerance)
            return march;
        ++march.lookups;
        march.before = march.z;
        march.z += coneStep(textures::sampleNearest(ratio, place.x, place.y, relief.wrap),
                            march.gap, speed);
    }
    march.converged = false;
    return march;
}

MapSearchResult searchByCones(const textures::DepthMap& relief, const textures::Plane& ratio,
                              const DescendingRay& ray, const SearchEnd& end) {
    const ConeMarch march = marchByCones(relief, ratio, ray, end);
    return {march.z, march.converged, march.lookups};
}

MapSearchResult searchByConesAndCells(const textures::DepthMap& relief,
                                      const textures::Plane& ratio, const DescendingRay& ray) {
    const double speed = ray.speed(relief.aspect());
    MapSearchResult result;
    for (CellWalk walk = walkOver(relief, ray);;) {
        ++result.lookups;
        if (const std::optional<double> hit = hitInCell(walk)) {
            result.z = *hit;
            return result;
        }
        if (walk.isLast())
            return result;
        ++result.lookups;
        const double z = walk.entry();
        const glm::dvec2 place = ray.at(z);
        const double gap = walk.surface().depth(walk.local(z)) - z;
        const double next =
            z + coneStep(textures::sampleNearest(ratio, place.x, place.y, relief.wrap), gap, speed);
        if (walk.isBeyond(next))
            walk.jump(std::min(next, 1.0));
        else
            walk.step();
    }
}

}  // namespace relievo::reference
