#include "viewer/texture_files.h"

#include <fmt/format.h>

#include <charconv>

#include "textures/input_error.h"
#include "textures/picture_file.h"

namespace relievo::viewer {
namespace {

// As many planes as the format has channels.
std::vector<textures::Plane> readPlanes(const std::filesystem::path& file,
                                        const materials::SurfaceTextureFormat& format) {
    std::vector<textures::Plane> planes = textures::readPicture(file);
    const auto wanted = static_cast<std::size_t>(format.channels);
    if (planes.size() < wanted && format.name == "orm")
        throw textures::InputError(
            fmt::format("{}: too few channels ({}), expected occlusion, roughness, metalness",
                        file.string(), planes.size()));
    if (planes.size() < wanted)
        planes.resize(1);
    planes.resize(wanted, planes.front());
    return planes;
}

// The depth scale that the file's occlusion was built for.
float bakedScale(const textures::MapSet& maps, const std::string& file) {
    const auto found = maps.attributes.find("relievo:normal-scale");
    const std::string text = found == maps.attributes.end() ? "" : found->second;
    float scale = 0.0f;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), scale);
    if (error != std::errc() || stop != text.data() + text.size() || !(scale > 0.0f))
        throw textures::InputError(
            fmt::format("{}: its attribute 'relievo:normal-scale' is '{}', expected the depth "
                        "scale above 0 that its occlusion is for",
                        file, text));
    return scale;
}

void takeBakedOcclusion(materials::TextureSet& set, const textures::MapSet& maps,
                        const std::string& file) {
    const textures::Plane* occlusion = maps.find("occlusion");
    if (occlusion == nullptr)
        throw textures::InputError(
            fmt::format("{}: no channel \"occlusion\", which is needed here; bake it with "
                        "relievo-bake relief --maps …,occlusion",
                        file));
    set.pictures["occlusion"] = {*occlusion};
    set.occlusionScale = bakedScale(maps, file);
}

}  // namespace

materials::TextureSet readTextureSet(const std::map<std::string, std::filesystem::path>& files,
                                     bool bakedOcclusion, const textures::MapSet& maps,
                                     const std::string& mapFile) {
    materials::TextureSet set;
    for (const materials::SurfaceTextureFormat& format : materials::surfaceTextureFormats())
        if (const auto file = files.find(std::string(format.name)); file != files.end())
            set.pictures[std::string(format.name)] = readPlanes(file->second, format);
    if (bakedOcclusion)
        takeBakedOcclusion(set, maps, mapFile);
    return set;
}

}  // namespace relievo::viewer
