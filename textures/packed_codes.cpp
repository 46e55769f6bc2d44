#include "textures/packed_codes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "textures/channel_rules.h"

namespace relievo::textures {

namespace {

/// The smallest number of `bits` significant bits that is at least `value` > 0.
double roundUpToBits(double value, int bits) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    return std::ldexp(std::ceil(std::ldexp(mantissa, bits)), exponent - bits);
}

/// Code 2^(n-1) is exactly 0, and the step has so few bits that step·code is an exact float.
ChannelRange signedRange(const Plane& values, StorageFormat format) {
    const double zero = format == StorageFormat::U16 ? 32768.0 : 128.0;
    const int stepBits = format == StorageFormat::U16 ? 9 : 17;
    double step = 0.0;
    for (const float value : values.texels)
        step = std::max(step, value > 0.0f ? value / (zero - 1.0) : -value / zero);
    step = step > 0.0 ? roundUpToBits(step, stepBits) : 1.0;
    return {-zero * step, (zero - 1.0) * step};
}

ChannelRange ratioRange(const Plane& values) {
    float top = 0.0f;
    for (const float value : values.texels)
        if (std::isfinite(value))
            top = std::max(top, value);
    return {0.0, top > 0.0f ? std::min(1.0, static_cast<double>(top)) : 1.0};
}

float codeToValue(double code, const ChannelRange& range, double maximum) {
    return static_cast<float>(range.low + (range.high - range.low) * code / maximum);
}

double scaledToCodes(float value, const ChannelRange& range, double maximum) {
    return (value - range.low) / (range.high - range.low) * maximum;
}

double nearestCode(float value, const ChannelRange& range, double maximum) {
    return std::clamp(std::nearbyint(scaledToCodes(value, range, maximum)), 0.0, maximum);
}

/// Found by comparing stored values, so that no rounding on the way back lifts one above the truth
/// and a value that has a code of its own keeps it.
double codeBelow(float value, const ChannelRange& range, double maximum) {
    double code = std::clamp(std::floor(scaledToCodes(value, range, maximum)), 0.0, maximum);
    while (code < maximum && codeToValue(code + 1.0, range, maximum) <= value)
        code += 1.0;
    while (code > 0.0 && codeToValue(code, range, maximum) > value)
        code -= 1.0;
    return code;
}

}  // namespace

double maximumCode(StorageFormat format) {
    assert(format == StorageFormat::U16 || format == StorageFormat::U8);
    return format == StorageFormat::U16 ? 65535.0 : 255.0;
}

ChannelRange packedRange(const Plane& values, std::string_view channel, StorageFormat format) {
    const ChannelRule rule = channelRule(channel);
    if (rule.isUnitRange)
        return {0.0, 1.0};
    return rule.isSigned ? signedRange(values, format) : ratioRange(values);
}

Plane packedCodes(const Plane& values, std::string_view channel, const ChannelRange& range,
                  StorageFormat format) {
    const double maximum = maximumCode(format);
    const auto toCode = channelRule(channel).rounding == Rounding::Down ? codeBelow : nearestCode;
    Plane codes(values.width, values.height);
    std::transform(values.texels.begin(), values.texels.end(), codes.texels.begin(),
                   [&](float value) { return static_cast<float>(toCode(value, range, maximum)); });
    return codes;
}

Plane packedValues(const Plane& codes, const ChannelRange& range, StorageFormat format) {
    const double maximum = maximumCode(format);
    Plane values(codes.width, codes.height);
    std::transform(codes.texels.begin(), codes.texels.end(), values.texels.begin(),
                   [&](float code) { return codeToValue(code, range, maximum); });
    return values;
}

}  // namespace relievo::textures
