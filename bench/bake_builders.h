#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "preprocess/conservative_cones.h"
#include "preprocess/derivatives.h"
#include "preprocess/distance_transform.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::bench {

/// What map builders start from.
struct BakeInput {
    textures::DepthMap map;
    preprocess::Derivatives derivatives;
    /// For distances: one byte a texel, 1 above the median depth of the map, 0 elsewhere.
    std::vector<std::uint8_t> raised;
    /// The opposite, which is what OpenCV starts from.
    std::vector<std::uint8_t> lowered;
};

/// The input made of a relief.
BakeInput makeBakeInput(textures::DepthMap map);

/// What is measured of a result besides the time. Where a builder has none of it, it is left empty.
struct BakeOutput {
    std::optional<textures::Plane> ratios;                          ///< of cones
    std::optional<preprocess::SlopeSearchStatistics> search;        ///< the work of a cone search
    std::optional<preprocess::SquaredDistances> doubtfulDistances;  ///< to be checked
};

/// A map builder that can be measured. Adding one is an entry in bake_builders.cpp.
struct BakeBuilder {
    std::string_view name;
    std::string_view description;
    /// Larger maps take too long: N×N texels; 0 for no limit.
    int largestSize = 0;
    /// Null when the program was built without what it needs.
    BakeOutput (*build)(const BakeInput& input) = nullptr;
};

/// Derivatives, normals, distances and all kinds of cones.
std::span<const BakeBuilder> bakeBuilders();

/// The builder of this name; throws std::invalid_argument when there is none.
const BakeBuilder& bakeBuilder(std::string_view name);

}  // namespace relievo::bench
