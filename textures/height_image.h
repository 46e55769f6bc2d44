#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "textures/depth_map.h"

namespace relievo::textures {

/// How to read a height image.
struct HeightImageOptions {
    bool isDepth = false;  ///< the image holds depth (white is deep) instead of height
    std::string channel;   ///< channel number or name; "" takes Y or R, else luminance
    WrapMode wrap = WrapMode::Repeat;
    /// Called with one sentence when the reader had to choose (for instance: luminance of RGB).
    std::function<void(const std::string&)> notice;
};

/// A height image as a relief.
struct HeightImage {
    DepthMap depth;
    /// 16 hexadecimal digits: a hash of the size and the depths, whatever the file format was.
    std::string source;
};

/// Reads any image that OpenImageIO reads: 8/16-bit integers map to [0,1], float values must lie in
/// [0,1]. The channel is the one that was asked for, else the only one, else `Y`, else `R` when
/// red, green and blue are equal, else the Rec. 709 luminance (with a notice); alpha is used only
/// when asked for. Throws InputError for a missing, foreign, truncated, empty or oversized file,
/// values that are not finite or out of range, and a channel that the file lacks.
HeightImage readHeightImage(const std::filesystem::path& file, const HeightImageOptions& options);

}  // namespace relievo::textures
