#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "preprocess/view_grid.h"
#include "textures/map_set.h"
#include "textures/storage_format.h"

namespace relievo::preprocess {

/// The fewest and the most azimuths of horizons: ellipses need three.
inline constexpr int kFewestAzimuths = 3;
inline constexpr int kMostAzimuths = 256;

/// The farthest that the map `extrema` may reach, in texels.
inline constexpr int kFarthestReach = 1024;

/// The most layers that the map `volume` may have.
inline constexpr int kMostSlices = 256;

/// The most terms that the map `vdm` may be packed into.
inline constexpr int kMostTerms = 64;

/// Which maps to bake of a relief, and how, in the words of `relievo-bake relief`.
struct ReliefPlan {
    std::vector<std::string> maps = {"depth", "derivative", "cone"};  ///< names of mapKinds()
    std::string cone = "conservative";                                ///< words of coneKinds()
    std::string guarantee;       ///< "": the first that coneKinds() has for the rest
    std::string method;          ///< likewise
    std::optional<int> sectors;  ///< of ray directions; none: coneSectors() says
    std::optional<textures::ConeEncoding> encoding;  ///< none: that of the kind of cones
    /// What the file will hold: the maps are those of the depths after this rounding.
    textures::StorageFormat format = textures::StorageFormat::Float;
    bool mips = false;  ///< MIP levels down to 1×1, each with its own maps
    /// Depth scale of the maps `normal`, `occlusion` and `ellipse`, in tile widths.
    double normalScale = 0.1;
    int reach = 4;  ///< of the map `extrema`, in texels
    /// Of the map `cylinder`: rays that are never deeper than this below the surface do not count.
    double cylinderTolerance = 0.01;
    int azimuths = 8;          ///< of the maps `horizon`, `occlusion` and `ellipse`
    int slices = 16;           ///< layers of the map `volume`
    double volumeScale = 0.1;  ///< depth scale of the map `volume`, in tile widths
    ViewGrid views;            ///< of the map `vdm`
    int terms = 8;             ///< into which the map `vdm` is packed; 0: the table itself

    [[nodiscard]] bool has(std::string_view map) const {
        return std::find(maps.begin(), maps.end(), map) != maps.end();
    }
};

}  // namespace relievo::preprocess
