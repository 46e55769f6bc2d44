#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "textures/depth_map.h"
#include "textures/map_set.h"

namespace relievo::textures {

/// The number format of a file: EXR holds Float and Half, PNG and TIFF hold U16 and U8.
enum class StorageFormat { Float, Half, U16, U8 };

/// How to read a height image.
struct HeightImageOptions {
    bool isDepth = false;  ///< the image holds depth (white is deep) instead of height
    std::string channel;   ///< channel number or name; "" takes Y or R, else luminance
    WrapMode wrap = WrapMode::Repeat;
    /// Called with one sentence when the reader had to choose (for instance: luminance of RGB).
    std::function<void(const std::string&)> notice;
};

/// A height image and the hash of what was read (its texels and how they were interpreted).
struct HeightImage {
    DepthMap depth;
    std::string source;
};

/// Reads any image that OpenImageIO reads: 8/16-bit integers map to [0,1], float values must lie in
/// [0,1]. Throws InputError for a missing, foreign, truncated or empty file, values that are not
/// finite or out of range, and a channel that the file lacks.
HeightImage readHeightImage(const std::filesystem::path& file, const HeightImageOptions& options);

/// Writes a map file: `.exr` (Float, Half; named channels) or `.png`, `.tif`, `.tiff` (U16, U8; up
/// to four channels packed as RGBA, with names and ranges in the metadata). Values are rounded to
/// the nearest code, `cone` down. The file appears whole or not at all. Throws InputError when the
/// format and the extension do not go together, when there are too many channels for a packed file,
/// or when writing fails. The same maps give the same bytes.
void writeMapFile(const std::filesystem::path& file, const MapSet& maps, StorageFormat format);

/// Reads a map file written by writeMapFile. Throws InputError that names the missing or senseless
/// attribute or channel.
MapSet readMapFile(const std::filesystem::path& file);

}  // namespace relievo::textures
