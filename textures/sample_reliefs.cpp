#include "textures/sample_reliefs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "textures/input_error.h"
#include "textures/sample_lettering.h"
#include "textures/sample_masonry.h"
#include "textures/sample_solids.h"
#include "textures/sample_terrain.h"

namespace relievo::textures {

namespace {

constexpr std::array kReliefs{
    SampleRelief{"noise",
                 "fractal noise: rugged ground",
                 noiseSurface,
                 {0.62, 0.58, 0.50},
                 {0.30, 0.27, 0.22},
                 0.0},
    SampleRelief{"cobbles",
                 "rounded stones with joints",
                 cobbleSurface,
                 {0.56, 0.54, 0.52},
                 {0.25, 0.22, 0.18},
                 0.32},
    SampleRelief{"bricks",
                 "a brick wall in running bond",
                 brickSurface,
                 {0.63, 0.29, 0.20},
                 {0.66, 0.63, 0.58},
                 0.28},
    SampleRelief{"blocks",
                 "square plateaus of many heights",
                 blockSurface,
                 {0.60, 0.62, 0.66},
                 {0.36, 0.42, 0.52},
                 0.20},
    SampleRelief{"pillars",
                 "sparse thin high pillars",
                 pillarSurface,
                 {0.84, 0.80, 0.70},
                 {0.38, 0.42, 0.34},
                 0.12},
    SampleRelief{"spikes",
                 "sharp cones close together",
                 spikeSurface,
                 {0.82, 0.84, 0.88},
                 {0.22, 0.25, 0.32},
                 0.15},
    SampleRelief{"ridge",
                 "a long ridge whose crest slopes",
                 ridgeSurface,
                 {0.80, 0.72, 0.56},
                 {0.52, 0.42, 0.30},
                 0.0},
    SampleRelief{"hemispheres",
                 "half balls on a floor",
                 hemisphereSurface,
                 {0.78, 0.52, 0.26},
                 {0.34, 0.34, 0.38},
                 0.22},
    SampleRelief{"wave",
                 "a smooth sum of two waves",
                 waveSurface,
                 {0.56, 0.72, 0.80},
                 {0.16, 0.34, 0.50},
                 0.0},
    SampleRelief{"lettering",
                 "the word RELIEVO on a rough plate",
                 letteringSurface,
                 {0.78, 0.62, 0.32},
                 {0.26, 0.30, 0.30},
                 0.06},
};

}  // namespace

std::span<const SampleRelief> sampleReliefs() {
    return kReliefs;
}

const SampleRelief& findSampleRelief(std::string_view name) {
    const auto found =
        std::find_if(kReliefs.begin(), kReliefs.end(),
                     [&](const SampleRelief& relief) { return relief.name == name; });
    if (found != kReliefs.end())
        return *found;
    std::string names;
    for (const SampleRelief& relief : kReliefs)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", relief.name);
    throw InputError(
        fmt::format("no sample relief is called '{}', expected one of {}", name, names));
}

DepthMap generateSampleRelief(std::string_view name, int width, int height, std::uint32_t seed) {
    const SampleRelief& relief = findSampleRelief(name);
    if (width < 1 || height < 1)
        throw InputError(fmt::format("a sample relief of {} x {} texels, expected at least 1 x 1",
                                     width, height));
    const SampleTile tile{static_cast<double>(height) / width, seed};
    DepthMap map{Plane(width, height), WrapMode::Repeat};
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            map.depth.at(i, j) = static_cast<float>(
                relief.surface((i + 0.5) / width, (j + 0.5) / height, tile).depth);
    return map;
}

}  // namespace relievo::textures
