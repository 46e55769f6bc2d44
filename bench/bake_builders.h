#pragma once

#include <any>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "preprocess/conservative_cones.h"
#include "preprocess/derivatives.h"
#include "preprocess/distance_transform.h"
#include "preprocess/shape_source.h"
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
    /// For shape maps: a bitmap of how much of each texel is above the median.
    preprocess::ShapeSource shape;
};

/// The input made of a relief.
BakeInput makeBakeInput(textures::DepthMap map);

/// What a builder made. Where it has none of what is measured, that is left empty.
struct BakeOutput {
    /// Of cones; with fewer texels than the map when only some of them were built.
    std::optional<textures::Plane> ratios;
    std::optional<preprocess::SlopeSearchStatistics> search;        ///< the work of a cone search
    std::optional<preprocess::SquaredDistances> doubtfulDistances;  ///< to be checked
    std::any others;  ///< maps of which nothing is measured, but that are output all the same
};

/// A map builder that can be measured. Adding one is an entry in bake_builders.cpp; maps that
/// `relievo-bake relief` learns to build are there by themselves.
struct BakeBuilder {
    std::string name;
    std::string description;
    /// Empty when the program was built without what it needs.
    std::function<BakeOutput(const BakeInput& input)> build;
    int largestSize = 0;  ///< larger maps take longer than most want to wait: N×N; 0: no limit
    /// What it builds, where there are several ways to: builders of one product are compared.
    std::string_view product = {};
    bool isBaseline = false;  ///< what the others of that product are compared with
    /// Bytes a texel besides map and result that relievo-bake counts on before it starts.
    std::optional<double> statedBytes = {};
};

/// Derivatives, normals, distances, all kinds of cones, the other maps of `relievo-bake relief`,
/// and all that it builds by default.
std::span<const BakeBuilder> bakeBuilders();

/// The builder of this name; throws std::invalid_argument when there is none.
const BakeBuilder& bakeBuilder(std::string_view name);

}  // namespace relievo::bench
