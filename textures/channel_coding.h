#pragma once

#include <span>
#include <string_view>

#include "textures/channel_rules.h"
#include "textures/map_set.h"
#include "textures/plane.h"
#include "textures/storage_format.h"

namespace relievo::textures {

/// What the lowest and the highest code of a packed channel stand for; codes between are evenly
/// spaced.
struct ChannelRange {
    double low = 0.0;
    double high = 1.0;
};

/// How one channel lies in a file: its samples are the values themselves (Float, Half), or codes
/// (U8, U16) that stand for low + (high − low)·code/maximum, or for the square of that.
struct ChannelCoding {
    StorageFormat format = StorageFormat::Float;
    ChannelRule rule;
    ChannelRange range;   ///< packed formats
    bool isRoot = false;  ///< the codes stand for square roots of the values
};

/// 255 for U8, 65535 for U16; packed formats only.
double maximumCode(StorageFormat format);

/// Whether the codes of a channel stand for square roots: those of widths of cones in a packed file
/// of the encoding Sqrt.
bool isStoredAsRoot(const ChannelRule& rule, StorageFormat format, ConeEncoding encoding);

/// The coding of the channel called `channel` with a range that holds the values of all `levels`:
/// [0,1] for depths and roofs. For widths of cones [least value, greatest finite value but at most
/// 1], as in the thesis, where 8-bit ratios clamp at π/4; so code 0 is not 0, where a search would
/// stall, unless a value is. (When all are over 1 the range goes up to the greatest.) For channels
/// of both signs one in which 0 has a code of its own and every code stands for an exact float, so
/// that storing what was read changes nothing; for distances that are nowhere below 0
/// [0, greatest].
ChannelCoding channelCoding(std::span<const Plane* const> levels, std::string_view channel,
                            StorageFormat format, ConeEncoding encoding = ConeEncoding::Ratio);

/// The samples, whole codes or floats, of `values`: the nearest ones, or for channels that are
/// rounded down those whose values are never above the true ones (unless they are under the
/// range's), or towards zero those never farther from 0. Infinite widths of cones become
/// kLargestHalf or the highest code. The spans are of one size and may be the same.
void toSamples(const ChannelCoding& coding, std::span<const float> values,
               std::span<float> samples);

/// The values that samples stand for, in their place.
void toValues(const ChannelCoding& coding, std::span<float> samples);

}  // namespace relievo::textures
