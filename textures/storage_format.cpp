#include "textures/storage_format.h"

#include <algorithm>
#include <cmath>

#include "textures/channel_rules.h"
#include "textures/packed_codes.h"

namespace relievo::textures {

namespace {

/// Rounded to the 11 significant bits of a half (fewer below 2^-14).
float roundToHalf(float value, Rounding rounding) {
    int exponent = 0;
    std::frexp(value, &exponent);
    const double quantum = std::ldexp(1.0, std::max(exponent, -13) - 11);
    const double steps = value / quantum;
    const double whole = rounding == Rounding::Down ? std::floor(steps) : std::nearbyint(steps);
    return static_cast<float>(whole * quantum);
}

/// Ratios end at the largest half in both float formats, so that infinite ones stay the widest.
Plane unpackedValues(const Plane& values, const ChannelRule& rule, StorageFormat format) {
    Plane stored = values;
    for (float& value : stored.texels) {
        if (rule.rounding == Rounding::Down)
            value = std::min(value, kLargestHalf);
        if (format == StorageFormat::Half)
            value = roundToHalf(value, rule.rounding);
    }
    return stored;
}

}  // namespace

Plane storedValues(const Plane& values, std::string_view channel, StorageFormat format) {
    if (!isPackedFormat(format))
        return unpackedValues(values, channelRule(channel), format);
    const ChannelRange range = packedRange(values, channel, format);
    return packedValues(packedCodes(values, channel, range, format), range, format);
}

std::size_t countVanishing(const Plane& values, std::string_view channel, StorageFormat format) {
    const Plane stored = storedValues(values, channel, format);
    std::size_t count = 0;
    for (std::size_t t = 0; t < values.texels.size(); ++t)
        count += values.texels[t] > 0.0f && stored.texels[t] == 0.0f ? 1 : 0;
    return count;
}

}  // namespace relievo::textures
