#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "textures/plane.h"
#include "textures/storage_format.h"

namespace relievo::textures {

/// The content of an image file.
struct ImageContent {
    /// Planes of one size: whole codes for U8 and U16, values otherwise.
    std::vector<Plane> planes;
    /// One name a plane, kept by EXR only; empty for grey, RGB or RGBA.
    std::vector<std::string> channelNames;
    StorageFormat format = StorageFormat::U8;
    /// Text attributes: PNG and EXR keep any, TIFF only standard ones such as ImageDescription.
    std::map<std::string, std::string> attributes;
    bool isColour = false;  ///< sRGB colours, for viewers; data otherwise
};

/// Writes an image in the format that the extension of `file` names, whole or not at all; the same
/// content gives the same bytes. Throws InputError when it cannot be written.
void writeImage(const std::filesystem::path& file, const ImageContent& content);

}  // namespace relievo::textures
