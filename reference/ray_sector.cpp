#include "reference/ray_sector.h"

#include <cassert>
#include <cmath>

namespace relievo::reference {

int raySector(const glm::dvec2& direction, double aspect, int sectors) {
    assert(sectors == 1 || sectors == 4 || sectors == 8);
    if (sectors == 1)
        return 0;
    const int quadrant = (direction.x < 0.0 ? 1 : 0) + (direction.y < 0.0 ? 2 : 0);
    const bool isSteep = std::abs(direction.y * aspect) > std::abs(direction.x);
    return quadrant + (sectors == 8 && isSteep ? 4 : 0);
}

}  // namespace relievo::reference
