#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "textures/cone_encoding.h"
#include "textures/plane.h"

namespace relievo::textures {

/// The number format of a map file: EXR holds Float and Half, PNG and TIFF hold U16 and U8.
enum class StorageFormat { Float, Half, U16, U8 };

/// "float", "half", "u16" or "u8": the words of the command line.
constexpr std::string_view storageFormatName(StorageFormat format) noexcept {
    switch (format) {
        case StorageFormat::Float:
            return "float";
        case StorageFormat::Half:
            return "half";
        case StorageFormat::U16:
            return "u16";
        case StorageFormat::U8:
            break;
    }
    return "u8";
}

/// The inverse of storageFormatName; nothing for any other word.
constexpr std::optional<StorageFormat> storageFormatFromName(std::string_view name) noexcept {
    for (const StorageFormat format :
         {StorageFormat::Float, StorageFormat::Half, StorageFormat::U16, StorageFormat::U8})
        if (storageFormatName(format) == name)
            return format;
    return std::nullopt;
}

/// Whether a file of this format packs its channels into integer codes (PNG, TIFF).
constexpr bool isPackedFormat(StorageFormat format) noexcept {
    return format == StorageFormat::U16 || format == StorageFormat::U8;
}

/// The largest finite half: what an infinite ratio is stored as in EXR files, Half or Float.
inline constexpr float kLargestHalf = 65504.0f;

/// The values that a reader of the file gets back for a channel called `channel`: rounded to what
/// `format` holds, widths of cones and roofs down, distances towards 0 and other channels to the
/// nearest. A second pass changes nothing. Infinite ratios become kLargestHalf, or the top of the
/// packed range. Builders apply it to the depths before they build cones, so that the cones are
/// safe for the depths that are really stored. Values above kLargestHalf in other channels do not
/// fit Half: writeMapFile refuses them.
Plane storedValues(const Plane& values, std::string_view channel, StorageFormat format,
                   ConeEncoding encoding = ConeEncoding::Ratio);

/// storedValues without a second plane.
void storeInPlace(Plane& values, std::string_view channel, StorageFormat format,
                  ConeEncoding encoding = ConeEncoding::Ratio);

/// What storing the widths of cones costs. A narrower cone is safe and makes a search take more
/// steps.
struct StorageLoss {
    std::size_t cones = 0;      ///< those with an end and a width, which the rest is about
    double meanShare = 1.0;     ///< mean of stored width / true width
    double worstShare = 1.0;    ///< least of these
    std::size_t vanishing = 0;  ///< become 0, where a search stalls
    std::size_t narrowed = 0;   ///< are above the largest value that the file holds
    double widest = 0.0;        ///< this largest value
};

/// Measures it for the channel of a map file, in which `cone` may be ratio or radius alike.
StorageLoss storageLoss(const Plane& values, std::string_view channel, StorageFormat format,
                        ConeEncoding encoding = ConeEncoding::Ratio);

}  // namespace relievo::textures
