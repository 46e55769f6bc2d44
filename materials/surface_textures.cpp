#include "materials/surface_textures.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "materials/relief_maps.h"

namespace relievo::materials {
namespace {

constexpr SurfaceTextureFormat kFormats[] = {
    {.name = "albedo",
     .sampler = "relievoAlbedoMap",
     .define = "RELIEVO_ALBEDO_MAP",
     .channels = 3,
     .internalFormat = GL_SRGB8_ALPHA8,
     .isMicrofacetOnly = false},
    {.name = "occlusion",
     .sampler = "relievoOcclusionMap",
     .define = "RELIEVO_OCCLUSION_MAP",
     .channels = 1,
     .internalFormat = GL_R8,
     .isMicrofacetOnly = false},
    {.name = "roughness",
     .sampler = "relievoRoughnessMap",
     .define = "RELIEVO_ROUGHNESS_MAP",
     .channels = 1,
     .internalFormat = GL_R8,
     .isMicrofacetOnly = true},
    {.name = "metalness",
     .sampler = "relievoMetalnessMap",
     .define = "RELIEVO_METALNESS_MAP",
     .channels = 1,
     .internalFormat = GL_R8,
     .isMicrofacetOnly = true},
    {.name = "orm",
     .sampler = "relievoOrmMap",
     .define = "RELIEVO_ORM_MAP",
     .channels = 3,
     .internalFormat = GL_RGBA8,
     .isMicrofacetOnly = false},
};

// A texture with a mip chain: what distant surfaces show must be averages; of colours, in linear
// light.
gl::Texture upload(const std::vector<textures::Plane>& planes, const SurfaceTextureFormat& format,
                   textures::WrapMode wrap) {
    const textures::Plane& first = planes.front();
    const std::size_t channels = planes.size();
    std::vector<float> texels(first.texels.size() * channels);
    for (std::size_t c = 0; c < channels; ++c)
        for (std::size_t k = 0; k < first.texels.size(); ++k)
            texels[k * channels + c] = planes[c].texels[k];
    const auto longest = static_cast<unsigned>(std::max(first.width, first.height));
    gl::Texture texture(first.width, first.height, format.internalFormat, 0,
                        static_cast<int>(std::bit_width(longest)));
    texture.upload(texels, format.channels);
    texture.setSampling(glWrapMode(wrap), GL_LINEAR);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateTextureMipmap(texture.id());
    return texture;
}

}  // namespace

std::span<const SurfaceTextureFormat> surfaceTextureFormats() {
    return kFormats;
}

SurfaceTextures::SurfaceTextures(TextureSet set, textures::WrapMode wrap)
    : set_(std::move(set)), wrap_(wrap) {
    assert(std::ranges::all_of(set_.pictures, [](const auto& picture) {
        const auto format = std::ranges::find(kFormats, picture.first, &SurfaceTextureFormat::name);
        return format != std::end(kFormats) &&
               picture.second.size() == static_cast<std::size_t>(format->channels);
    }));
    assert(!has("orm") || !(has("occlusion") || has("roughness") || has("metalness")));
}

bool SurfaceTextures::reads(const SurfaceTextureFormat& format, const Shading& shading) const {
    return has(format.name) &&
           (shading.model == ShadingModel::Microfacet || !format.isMicrofacetOnly);
}

std::vector<shaders::Define> SurfaceTextures::defines(const Shading& shading) const {
    std::vector<shaders::Define> result;
    if (shading.model == ShadingModel::Microfacet)
        result.push_back({"RELIEVO_MICROFACET", "1"});
    for (const SurfaceTextureFormat& format : kFormats)
        if (reads(format, shading))
            result.push_back({std::string(format.define), "1"});
    if (set_.occlusionScale > 0.0f && has("occlusion"))
        result.push_back({"RELIEVO_OCCLUSION_BAKED", "1"});
    return result;
}

GLuint SurfaceTextures::bind(gl::Program& program, const Shading& shading, GLuint firstUnit) {
    GLuint unit = firstUnit;
    for (const SurfaceTextureFormat& format : kFormats)
        if (reads(format, shading)) {
            program.set(format.sampler, static_cast<int>(unit));
            texture(format).bind(unit++);
        }
    if (set_.occlusionScale > 0.0f && has("occlusion"))
        program.set("relievoOcclusionScale", set_.occlusionScale);
    if (shading.model == ShadingModel::Microfacet && !has("orm")) {
        if (!has("roughness"))
            program.set("relievoRoughness", shading.roughness);
        if (!has("metalness"))
            program.set("relievoMetalness", shading.metalness);
    }
    return unit;
}

const gl::Texture& SurfaceTextures::texture(const SurfaceTextureFormat& format) {
    if (const auto found = textures_.find(format.name); found != textures_.end())
        return found->second;
    gl::Texture texture = upload(set_.pictures.find(format.name)->second, format, wrap_);
    return textures_.emplace(format.name, std::move(texture)).first->second;
}

}  // namespace relievo::materials
