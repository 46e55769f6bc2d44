#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "textures/cone_encoding.h"
#include "textures/depth_map.h"
#include "textures/plane.h"
#include "textures/wrap_mode.h"

namespace relievo::textures {

/// A named channel, with one of the names of the specification: `depth`, `dx`, `dy`, `nx`, `ny`,
/// `nz`, `cone`, `cylinder`, `volume0` …, `horizon0` …, `occlusion`, `dmin`, `dmax`, `ellipsex` …,
/// `vdm0` …, `vdmfactor0` …, `roof`, `ratio`, `roof0` …, and those of shape maps: `gx`, `gy`,
/// `distance`, `shape`.
struct Channel {
    std::string name;
    Plane plane;
};

/// The content of a map file: named channels of one size that describe one relief, and the metadata
/// that makes the file self-describing. Values are decoded: true depths, ratios and derivatives,
/// whatever the number format on disk.
struct MapSet {
    std::string kind = "relief";  ///< `relievo:kind`
    WrapMode wrap = WrapMode::Repeat;
    double texelAspect = 1.0;  ///< height of a texel over its width; not 1 in some mip levels
    ConeEncoding encoding = ConeEncoding::Ratio;
    std::string source;   ///< `relievo:source`: content hash of the height image ("" if unknown)
    std::string version;  ///< `relievo:version` of the program that wrote it
    /// Further attributes with their full names, such as `relievo:cone`, `relievo:method`,
    /// `relievo:normal-scale`.
    std::map<std::string, std::string> attributes;
    std::vector<Channel> channels;

    [[nodiscard]] int width() const noexcept {
        return channels.empty() ? 0 : channels.front().plane.width;
    }
    [[nodiscard]] int height() const noexcept {
        return channels.empty() ? 0 : channels.front().plane.height;
    }
    [[nodiscard]] const Plane* find(std::string_view name) const noexcept {
        for (const Channel& channel : channels)
            if (channel.name == name)
                return &channel.plane;
        return nullptr;
    }
};

/// The relief that a map set describes. Throws InputError when it has no channel `depth`.
DepthMap depthMapOf(const MapSet& maps);

}  // namespace relievo::textures
