#include "materials/relief_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <vector>

#include "textures/input_error.h"

namespace relievo::materials {
namespace {

constexpr std::string_view kDepthChannels[] = {"depth"};
constexpr std::string_view kDerivativeChannels[] = {"dx", "dy"};
constexpr std::string_view kConeChannels[] = {"cone"};

constexpr ReliefMapFormat kFormats[] = {
    {"depth", "relievoDepthMap", kDepthChannels, GL_R32F, GL_LINEAR},
    {"derivative", "relievoDerivativeMap", kDerivativeChannels, GL_RG32F, GL_LINEAR},
    // A cone belongs to its texel: between two of them neither is valid, let alone their mean.
    {"cone", "relievoConeMap", kConeChannels, GL_R32F, GL_NEAREST},
};

// Unlimited cones are infinite in memory, which a shader would turn into NaN (∞·0). This is as
// good: it leads out of any window in one step.
constexpr float kLargestUpload = 1e30f;

std::vector<float> interleave(const textures::MapSet& maps, const ReliefMapFormat& format) {
    const std::size_t channels = format.channels.size();
    const std::size_t texels =
        static_cast<std::size_t>(maps.width()) * static_cast<std::size_t>(maps.height());
    std::vector<float> result(texels * channels);
    for (std::size_t c = 0; c < channels; ++c) {
        const textures::Plane& plane = *maps.find(format.channels[c]);
        for (std::size_t k = 0; k < texels; ++k)
            result[k * channels + c] = std::min(plane.texels[k], kLargestUpload);
    }
    return result;
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

void ReliefMaps::require(std::string_view mapName) const {
    for (const std::string_view channel : reliefMapFormat(mapName).channels)
        if (!maps_.find(channel))
            throw textures::InputError(fmt::format(
                "{}: no channel \"{}\", which is needed here; bake it with "
                "relievo-bake relief --maps …,{}{}",
                name_, channel, mapName, mapName == "cone" ? " --cone conservative" : ""));
}

const gl::Texture& ReliefMaps::texture(std::string_view mapName) {
    const ReliefMapFormat& format = reliefMapFormat(mapName);
    if (const auto found = textures_.find(format.name); found != textures_.end())
        return found->second;
    require(mapName);
    gl::Texture texture(maps_.width(), maps_.height(), format.internalFormat);
    texture.upload(interleave(maps_, format), static_cast<int>(format.channels.size()));
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
