#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "materials/surface_textures.h"
#include "textures/map_set.h"

namespace relievo::viewer {

/// Reads the pictures of a texture set, `files` having the names of
/// materials::surfaceTextureFormats(), and with `bakedOcclusion` takes the occlusion that was baked
/// with `maps`, which errors call `mapFile`. A grey picture stands for a grey albedo; of a colour
/// picture that stands for one number the first channel counts. Throws textures::InputError.
materials::TextureSet readTextureSet(const std::map<std::string, std::filesystem::path>& files,
                                     bool bakedOcclusion, const textures::MapSet& maps,
                                     const std::string& mapFile);

}  // namespace relievo::viewer
