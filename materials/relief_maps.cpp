#include "materials/relief_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <vector>

#include "textures/input_error.h"
#include "textures/roof_layers.h"

namespace relievo::materials {
namespace {

constexpr std::string_view kDepthChannels[] = {"depth"};
constexpr std::string_view kDerivativeChannels[] = {"dx", "dy"};
constexpr std::string_view kConeChannels[] = {"cone"};
constexpr std::string_view kRoofChannels[] = {"roof", "ratio"};

constexpr ReliefMapFormat kFormats[] = {
    {"depth", "relievoDepthMap", kDepthChannels, GL_R32F, GL_LINEAR},
    {"derivative", "relievoDerivativeMap", kDerivativeChannels, GL_RG32F, GL_LINEAR},
    // A cone belongs to its texel: between two of them neither is valid, let alone their mean.
    {"cone", "relievoConeMap", kConeChannels, GL_R32F, GL_NEAREST, false, "conservative"},
    {"relaxed-cone", "relievoConeMap", kConeChannels, GL_R32F, GL_NEAREST, false, "relaxed"},
    {"roof", "relievoRoofMap", kRoofChannels, GL_RG32F, GL_NEAREST, true, "roof"},
};

// Unlimited cones are infinite in memory, which a shader would turn into NaN (∞·0). This is as
// good: it leads out of any window in one step.
constexpr float kLargestUpload = 1e30f;

std::vector<float> interleave(std::span<const textures::Plane* const> channels) {
    const std::size_t texels = channels.front()->texels.size();
    std::vector<float> result(texels * channels.size());
    for (std::size_t c = 0; c < channels.size(); ++c)
        for (std::size_t k = 0; k < texels; ++k)
            result[k * channels.size() + c] = std::min(channels[c]->texels[k], kLargestUpload);
    return result;
}

// How to bake a map that is missing.
std::string remedy(const ReliefMapFormat& format) {
    return fmt::format("bake it with relievo-bake relief --maps …,{}",
                       format.cones.empty() ? std::string(format.name)
                                            : fmt::format("cone --cone {}", format.cones));
}

// The kind of the cones in channel `cone`; other tools than ours make conservative ones.
std::string coneKindOf(const textures::MapSet& maps) {
    const auto found = maps.attributes.find("relievo:cone");
    return found == maps.attributes.end() ? "conservative" : found->second;
}

}  // namespace

std::span<const ReliefMapFormat> reliefMapFormats() {
    return kFormats;
}

const ReliefMapFormat& reliefMapFormat(std::string_view name) {
    const auto found = std::ranges::find(kFormats, name, &ReliefMapFormat::name);
    assert(found != std::end(kFormats));
    return *found;
}

ReliefMaps::ReliefMaps(textures::MapSet maps, std::string name)
    : maps_(std::move(maps)), name_(std::move(name)) {
    require("depth");
}

std::vector<const textures::Plane*> ReliefMaps::channelsOf(const ReliefMapFormat& format) const {
    std::vector<const textures::Plane*> planes;
    for (const std::string_view channel : format.channels) {
        planes.push_back(maps_.find(channel));
        if (planes.back() == nullptr)
            throw missing(format, channel);
    }
    if (!format.cones.empty() && format.cones != coneKindOf(maps_))
        throw textures::InputError(fmt::format("{}: holds {} cones, expected {} ones; {}", name_,
                                               coneKindOf(maps_), format.cones, remedy(format)));
    return planes;
}

std::vector<std::vector<const textures::Plane*>> ReliefMaps::layersOf(
    const ReliefMapFormat& format) const {
    if (!format.hasSectors)
        return {channelsOf(format)};
    std::vector<std::vector<const textures::Plane*>> layers;
    try {
        for (const textures::RoofLayer& layer : textures::roofLayersOf(maps_).layers)
            layers.push_back({layer.roof, layer.ratio});
    } catch (const textures::InputError& error) {
        throw textures::InputError(fmt::format("{}: {}", name_, error.what()));
    }
    if (layers.empty())
        throw missing(format, format.channels.front());
    return layers;
}

textures::InputError ReliefMaps::missing(const ReliefMapFormat& format,
                                         std::string_view channel) const {
    return textures::InputError(fmt::format("{}: no channel \"{}\", which is needed here; {}",
                                            name_, channel, remedy(format)));
}

void ReliefMaps::require(std::string_view mapName) const {
    static_cast<void>(layersOf(reliefMapFormat(mapName)));
}

const gl::Texture& ReliefMaps::texture(std::string_view mapName) {
    const ReliefMapFormat& format = reliefMapFormat(mapName);
    if (const auto found = textures_.find(format.name); found != textures_.end())
        return found->second;
    const auto layers = layersOf(format);
    const int count = static_cast<int>(layers.size());
    gl::Texture texture(maps_.width(), maps_.height(), format.internalFormat,
                        format.hasSectors ? count : 0);
    for (int layer = 0; layer < count; ++layer)
        texture.upload(interleave(layers[static_cast<std::size_t>(layer)]),
                       static_cast<int>(format.channels.size()), layer);
    texture.setSampling(glWrapMode(maps_.wrap), format.filter);
    return textures_.emplace(format.name, std::move(texture)).first->second;
}

GLenum glWrapMode(textures::WrapMode wrap) noexcept {
    switch (wrap) {
        case textures::WrapMode::Repeat:
            return GL_REPEAT;
        case textures::WrapMode::Mirror:
            return GL_MIRRORED_REPEAT;
        case textures::WrapMode::Clamp:
            break;
    }
    return GL_CLAMP_TO_EDGE;
}

}  // namespace relievo::materials
