#pragma once

#include <string_view>

namespace relievo::solids {

/// How a picture is put on a solid (thesis 4.6.3), in the tile space of the part: projected along
/// the depth, along v, or along u − v; from its axis or from the middle of the tile; or along the
/// axis that the surface faces most.
enum class SolidTexturing { PlanarZ, PlanarY, PlanarDiagonal, Cylindrical, Spherical, Box };

/// "planar-z", "planar-y", "planar-diagonal", "cylindrical", "spherical", "box": the words of
/// command lines and scene files.
std::string_view solidTexturingName(SolidTexturing texturing) noexcept;
/// The inverse. Throws textures::InputError, listing the names.
SolidTexturing findSolidTexturing(std::string_view name);

}  // namespace relievo::solids
