#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "textures/plane.h"

namespace relievo::textures {

/// What an image or a map file may take when decoded, in bytes: far beyond any texture, but short
/// of what a damaged header can claim. A map of 8192² texels may have 32 channels.
inline constexpr double kLargestImage = 1024.0 * 1024.0 * 1024.0;
inline constexpr double kLargestMap = 8.0 * kLargestImage;

/// How an image file holds its numbers. Other covers what is read as float: double, wide integers.
enum class SampleType { U8, U16, Half, Float, Other };

struct LevelSize {
    int width = 0;
    int height = 0;
};

/// What an image file says about itself, before its samples are read.
struct ImageInfo {
    int width = 0;
    int height = 0;
    SampleType type = SampleType::Other;
    std::vector<std::string> channelNames;
    std::map<std::string, std::string> attributes;  ///< the text attributes
    /// Sizes of the picture and of its MIP levels, if the file has some.
    std::vector<LevelSize> levels;
    int orientation = 1;  ///< the Exif number; 1 is upright
};

/// An image file of any format that OpenImageIO reads, open for reading. Samples come as they are
/// stored: no colour conversion, no multiplication by alpha.
class ImageReader {
  public:
    /// Throws InputError for a file that is missing, no regular file, empty, truncated (PNG, JPEG),
    /// no image, a deep or volume image, a crop, of zero size, wider or higher than 32768, or over
    /// `largest` bytes when decoded to floats.
    explicit ImageReader(std::filesystem::path file, double largest = kLargestImage);
    ~ImageReader();
    ImageReader(const ImageReader&) = delete;
    ImageReader& operator=(const ImageReader&) = delete;

    [[nodiscard]] const ImageInfo& info() const noexcept { return info_; }

    /// The channel with this name, or else with this number, from 0. Throws InputError when there
    /// is neither.
    [[nodiscard]] int channelIndex(const std::string& nameOrNumber) const;

    /// The samples of `count` channels from `first` on in one of the levels, decoded in one pass;
    /// 8/16-bit integers as code/maximum, rounded once. Takes little memory besides the planes, and
    /// no more than what the file really holds. Throws InputError when the file is truncated or
    /// damaged.
    [[nodiscard]] std::vector<Plane> readChannels(int first, int count, std::size_t level = 0);

    /// Decodes the last rows of the last level, which is where the end of a file is that was cut
    /// off. Throws InputError when they are not there.
    void requireEnd();

  private:
    struct Input;

    [[noreturn]] void rejectDamaged();

    std::filesystem::path file_;
    std::unique_ptr<Input> input_;
    ImageInfo info_;
};

}  // namespace relievo::textures
