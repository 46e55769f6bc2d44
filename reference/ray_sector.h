#pragma once

#include <glm/vec2.hpp>

namespace relievo::reference {

/// The sector, of 1, 4 or 8 that a map tells apart, of rays that go along `direction` (in (u,v))
/// over a tile of height/width `aspect`: 0, or the quadrant (du<0) + 2·(dv<0), of eight + 4 where
/// |dv| > |du| in the metric.
int raySector(const glm::dvec2& direction, double aspect, int sectors);

}  // namespace relievo::reference
