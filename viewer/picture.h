#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "textures/plane.h"

namespace relievo::viewer {

/// RGBA floats, sRGB-encoded colours in [0,1], rows from the top.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<float> rgba;

    Picture() = default;
    /// Transparent black.
    Picture(int width_, int height_)
        : width(width_),
          height(height_),
          rgba(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0f) {}

    [[nodiscard]] float* pixel(int x, int y) { return &rgba[index(x, y)]; }
    [[nodiscard]] const float* pixel(int x, int y) const { return &rgba[index(x, y)]; }

  private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x));
    }
};

/// Writes `.png`, `.tif` (8 bit) or `.exr` (half), whole or not at all. Throws
/// textures::InputError.
void writePicture(const std::filesystem::path& file, const Picture& picture);

/// Throws what writePicture would throw for a file that cannot be written, without writing it.
void requirePictureFile(const std::filesystem::path& file);

/// Reads a colour or grey image (an albedo) as sRGB-encoded values. Throws textures::InputError.
Picture readPicture(const std::filesystem::path& file);

/// Copies `source` into `target` with its top left corner at (x,y); it must fit.
void paste(Picture& target, const Picture& source, int x, int y);

/// A named plane of numbers.
struct NamedPlane {
    std::string name;
    textures::Plane plane;
};

/// Writes planes of one size as a float EXR with named channels. Throws textures::InputError.
void writeChannels(const std::filesystem::path& file, const std::vector<NamedPlane>& planes);

/// Throws what writeChannels would throw for a file that cannot be written, without writing it.
void requireChannelFile(const std::filesystem::path& file);

}  // namespace relievo::viewer
