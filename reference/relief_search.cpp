#include "reference/relief_search.h"

#include "reference/bisection.h"

namespace relievo::reference {

MapSearchResult searchLinearBinary(const textures::DepthMap& relief, const DescendingRay& ray,
                                   int linearSteps, int bisections) {
    MapSearchResult result;
    Bracket bracket{0.0, 0.0};
    for (int k = 1; k <= linearSteps; ++k) {
        ++result.lookups;
        bracket.below = static_cast<double>(k) / linearSteps;
        if (isBelow(relief, ray, bracket.below))
            break;
        bracket.above = bracket.below;
    }
    for (int k = 0; k < bisections; ++k)
        halve(relief, ray, bracket);
    result.lookups += bisections;
    result.z = bracket.below;
    return result;
}

}  // namespace relievo::reference
