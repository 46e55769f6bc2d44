#pragma once

#include "solids/free_space.h"
#include "solids/solid.h"
#include "solids/tile_metric.h"

namespace relievo::solids {

/// Lower bounds of the distances from a point to what is solid and to what is not, ≥ 0: at most one
/// of them is more than 0. Infinite where there is nothing of the kind.
struct DistanceBounds {
    double toSolid = 0.0;
    double toOutside = 0.0;
};

/// The bounds for one part, from one place of its map (27 of a revolution: those of the replicas
/// around). `place` is in the tile space of the part, the bounds are in the world of `metric`.
///
/// What is exact of it: walls of which d is the true distance, far from the outline in texels, and
/// bevels on them; window borders. At edges where several of them meet it is the largest of their
/// bounds.
DistanceBounds partBounds(const SolidPart& part, const FreeSpace& freeSpace,
                          const TileMetric& metric, const glm::dvec3& place);

}  // namespace relievo::solids
