#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "textures/plane.h"
#include "textures/storage_format.h"

namespace relievo::textures {

/// What is written of an image file besides its samples.
struct ImageDescription {
    /// One name a channel, kept by EXR only; empty for grey, RGB or RGBA.
    std::vector<std::string> channelNames;
    StorageFormat format = StorageFormat::U8;
    /// Text attributes: PNG and EXR keep any, TIFF only standard ones such as ImageDescription.
    std::map<std::string, std::string> attributes;
    bool isColour = false;  ///< sRGB colours, for viewers; data otherwise
};

/// Fills `samples` with one row of a channel: whole codes for U8 and U16, values otherwise.
using RowSource = std::function<void(int row, std::span<float> samples)>;

/// One picture of an image file: its size and where the samples of its channels come from.
struct ImageLevel {
    int width = 0;
    int height = 0;
    std::vector<RowSource> channels;
};

/// Writes an image in the format that the extension of `file` names, whole or not at all; the same
/// content gives the same bytes. `levels` are the picture and, for EXR and TIFF, its MIP levels,
/// each of half the size of the one before, rounded down. Rows are asked for a few at a time, so it
/// takes little memory besides what the sources hold. Throws InputError when it cannot be written.
void writeImage(const std::filesystem::path& file, const ImageDescription& description,
                std::span<const ImageLevel> levels);

/// An image whose samples are at hand.
struct ImageContent : ImageDescription {
    /// Planes of one size: whole codes for U8 and U16, values otherwise.
    std::vector<Plane> planes;
};

/// Writes it, likewise.
void writeImage(const std::filesystem::path& file, const ImageContent& content);

}  // namespace relievo::textures
