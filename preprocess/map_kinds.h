#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "preprocess/relief_plan.h"
#include "textures/depth_map.h"
#include "textures/map_set.h"

namespace relievo::preprocess {

/// What the builder of a map is given.
struct MapRequest {
    const textures::DepthMap& relief;  ///< the depths that the file will hold
    const ReliefPlan& plan;
    /// Called from any thread with numbers of texels that add up to those of the map.
    std::function<void(std::size_t)> advance;
};

/// One kind of map that can be baked. Adding one is an entry in map_kinds.cpp: the command line,
/// its checks and its help follow.
struct MapKind {
    std::string_view name;         ///< the word of `--maps`
    std::string_view description;  ///< the channels and what they are, for `--help`
    /// The names of its channels.
    std::vector<std::string> (*channels)(const ReliefPlan& plan);
    /// Adds its channels and attributes to the map set; returns what there is to say about the
    /// work ("64 levels"). Null for `depth`, which is there from the start.
    std::string (*build)(const MapRequest& request, textures::MapSet& maps);
    /// Bytes that building takes for each texel, besides the relief and the channels themselves.
    double (*workingBytes)(const ReliefPlan& plan);
};

/// All kinds, in the order in which they are built: the one that takes most memory first.
std::span<const MapKind> mapKinds();

/// The kind called `name`, or null.
const MapKind* findMapKind(std::string_view name);

/// How many channels the maps of `plan` have, which must all be known.
std::size_t channelCount(const ReliefPlan& plan);

}  // namespace relievo::preprocess
