#pragma once

#include <filesystem>
#include <string>

#include "textures/storage_format.h"

namespace relievo::textures {

/// The extension of `file` in lower case, with its dot.
std::string lowerExtension(const std::filesystem::path& file);

/// Throws InputError unless the extension of `file` can hold `format`: `.exr` for Float and Half,
/// `.png`, `.tif` or `.tiff` for U16 and U8.
void requireExtensionFor(const std::filesystem::path& file, StorageFormat format);

}  // namespace relievo::textures
