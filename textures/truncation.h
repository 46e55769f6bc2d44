#pragma once

#include <filesystem>

namespace relievo::textures {

/// Whether `file` is a PNG or JPEG file that ends before its end marker: the JPEG reader fills what
/// is missing with grey without an error, and the PNG one prints lines of its own. False for other
/// formats, whose readers fail properly, and for files that cannot be read.
bool isTruncatedImage(const std::filesystem::path& file);

/// Whether the header of a PNG file gives a width or a height of 0, about which its reader prints
/// lines of its own.
bool isPngOfNoSize(const std::filesystem::path& file);

}  // namespace relievo::textures
