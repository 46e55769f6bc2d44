#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::reference {

/// The channels of one sector of ray directions.
struct RoofLayer {
    textures::Plane roof;  ///< least depth over the block of each cell
    textures::Plane
        ratio;  ///< tile widths per unit of depth, of the empty cone with its apex there
};

/// Roof cones (specification 3.6) over the bilinear cells of a relief. Cell (i,j), between texel
/// centres i and i+1, j and j+1, is stored at texel (i,j).
///
/// One layer serves all directions, and the block of a cell is the cells within `block` of it. Four
/// or eight layers are for the sectors of raySector. The block of a sector is the cell and the
/// `block` next ones ahead along each axis.
struct RoofMap {
    std::vector<RoofLayer> layers;  ///< 1, 4 or 8
    int block = 1;
};

/// What a roof map says about a cell.
struct RoofCone {
    double roof = 0.0;
    double ratio = 0.0;
    int i = 0;  ///< the texel that says it
    int j = 0;
};

/// The roof cone of the cell with these numbers, which need not lie in the tile, for rays along
/// `direction`. In a mirrored tile the direction is mirrored as well. The cells between the last
/// texel of a tile and its copy in a clamped or mirrored one are level across and stored at the
/// border texel: the one before texel 0 shares it with cell 0 (in a mirrored map, as for rays that
/// go into the tile), so an octant must hold there what it reaches from either. Beyond, clamped
/// maps repeat their border cells.
RoofCone roofConeAt(const RoofMap& roofs, const textures::DepthMap& relief, std::int64_t column,
                    std::int64_t row, const glm::dvec2& direction);

/// The t ≥ 0 at which the line of texel coordinates (u·W − ½, v·H − ½) start + t·direction leaves
/// the block of the cell (column, row); infinity for a line that stands still.
double blockExit(const glm::dvec2& start, const glm::dvec2& direction, std::int64_t column,
                 std::int64_t row, int block);

}  // namespace relievo::reference
