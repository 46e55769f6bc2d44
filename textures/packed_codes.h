#pragma once

#include <string_view>

#include "textures/plane.h"
#include "textures/storage_format.h"

namespace relievo::textures {

/// The values of the lowest and the highest code of a packed channel; codes between are evenly
/// spaced.
struct ChannelRange {
    double low = 0.0;
    double high = 1.0;
};

/// 255 for U8, 65535 for U16; the two formats that the functions of this header are for.
double maximumCode(StorageFormat format);

/// The range that holds all `values` of the channel: [0,1] for depths; [0, largest finite value but
/// at most 1] for ratios, as in the thesis, where 8-bit ratios clamp at π/4; for channels of both
/// signs one in which 0 has a code of its own and every code stands for an exact float, so that
/// storing what was read changes nothing.
ChannelRange packedRange(const Plane& values, std::string_view channel, StorageFormat format);

/// The codes, as whole numbers, that stand for `values`: the nearest ones, or for channels that are
/// rounded down those whose values, as packedValues gives them, are never above the true ones.
Plane packedCodes(const Plane& values, std::string_view channel, const ChannelRange& range,
                  StorageFormat format);

/// The values that `codes` stand for.
Plane packedValues(const Plane& codes, const ChannelRange& range, StorageFormat format);

}  // namespace relievo::textures
