#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "textures/plane.h"
#include "textures/storage_format.h"

namespace relievo::textures {

/// Writes a picture: one plane for grey, three for RGB, four for RGBA (not multiplied by alpha).
/// U8 and U16 need `.png`, `.tif` or `.tiff` and take values in [0,1] (others are clamped) that
/// viewers show as sRGB; Half and Float need `.exr` and take any. The file appears whole or not at
/// all. Throws InputError when extension and format do not go together or writing fails.
void writePicture(const std::filesystem::path& file, std::span<const Plane> planes,
                  StorageFormat format);

/// Reads all channels of a picture as they are stored, integers scaled to [0,1]. Throws InputError
/// like readHeightImage.
std::vector<Plane> readPicture(const std::filesystem::path& file);

}  // namespace relievo::textures
