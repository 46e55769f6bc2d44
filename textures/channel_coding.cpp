#include "textures/channel_coding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace relievo::textures {

namespace {

/// The smallest number of `bits` significant bits that is at least `value` > 0.
double roundUpToBits(double value, int bits) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    return std::ldexp(std::ceil(std::ldexp(mantissa, bits)), exponent - bits);
}

/// Code 2^(n-1) is exactly 0, and the step has so few bits that step·code is an exact float.
ChannelRange signedRange(std::span<const Plane* const> levels, StorageFormat format) {
    const double zero = format == StorageFormat::U16 ? 32768.0 : 128.0;
    const int stepBits = format == StorageFormat::U16 ? 9 : 17;
    double step = 0.0;
    for (const Plane* level : levels)
        for (const float value : level->texels)
            step = std::max(step, value > 0.0f ? value / (zero - 1.0) : -value / zero);
    step = step > 0.0 ? roundUpToBits(step, stepBits) : 1.0;
    return {-zero * step, (zero - 1.0) * step};
}

/// The greatest step of 20 significant bits of which `codes` are not above `value` ≥ 0 as a float.
/// Found again from its own product: values that were stored keep their codes.
double stepWithin(float value, double codes) {
    int exponent = 0;
    std::frexp(value / codes, &exponent);
    const double quantum = std::ldexp(1.0, exponent - 20);
    double steps = std::floor(value / codes / quantum) + 1.0;
    while (static_cast<float>(codes * steps * quantum) > value)
        steps -= 1.0;
    return steps * quantum;
}

/// As signedRange, but what is rounded towards 0 must not need a code beyond the last: the greatest
/// value gets that one. With all codes for what there is when nothing is below 0.
ChannelRange distanceRange(std::span<const Plane* const> levels, StorageFormat format) {
    float least = 0.0f;
    float greatest = 0.0f;
    for (const Plane* level : levels)
        for (const float value : level->texels) {
            least = std::min(least, value);
            greatest = std::max(greatest, value);
        }
    if (least == 0.0f)
        return {0.0, greatest > 0.0f ? greatest : 1.0};
    const double zero = format == StorageFormat::U16 ? 32768.0 : 128.0;
    const double step = std::max(stepWithin(greatest, zero - 1.0), stepWithin(-least, zero));
    return {-zero * step, (zero - 1.0) * step};
}

/// Unlimited cones count for neither end.
ChannelRange coneRange(std::span<const Plane* const> levels) {
    constexpr float kWidest = 1.0f;
    float least = std::numeric_limits<float>::infinity();
    float greatest = 0.0f;
    for (const Plane* level : levels)
        for (const float value : level->texels)
            if (std::isfinite(value)) {
                least = std::min(least, value);
                greatest = std::max(greatest, value);
            }
    if (greatest == 0.0f)  // no cone has an end, or none a width
        return {0.0, kWidest};
    const float high = least < kWidest ? std::min(greatest, kWidest) : greatest;
    return {least < high ? least : 0.0f, high};
}

double codeValue(double code, const ChannelCoding& coding, double maximum) {
    const ChannelRange& range = coding.range;
    const double stored = range.low + (range.high - range.low) * code / maximum;
    return coding.isRoot ? stored * stored : stored;
}

double scaledToCodes(float value, const ChannelCoding& coding, double maximum) {
    const ChannelRange& range = coding.range;
    const double stored = coding.isRoot ? std::sqrt(static_cast<double>(value)) : value;
    return (stored - range.low) / (range.high - range.low) * maximum;
}

double nearestCode(float value, const ChannelCoding& coding, double maximum) {
    return std::clamp(std::nearbyint(scaledToCodes(value, coding, maximum)), 0.0, maximum);
}

/// Found by comparing stored values, so that no rounding on the way back lifts one above the truth
/// and a value that has a code of its own keeps it.
double codeBelow(float value, const ChannelCoding& coding, double maximum) {
    const auto stored = [&](double code) {
        return static_cast<float>(codeValue(code, coding, maximum));
    };
    double code = std::clamp(std::floor(scaledToCodes(value, coding, maximum)), 0.0, maximum);
    while (code < maximum && stored(code + 1.0) <= value)
        code += 1.0;
    while (code > 0.0 && stored(code) > value)
        code -= 1.0;
    return code;
}

double codeAbove(float value, const ChannelCoding& coding, double maximum) {
    const auto stored = [&](double code) {
        return static_cast<float>(codeValue(code, coding, maximum));
    };
    double code = std::clamp(std::ceil(scaledToCodes(value, coding, maximum)), 0.0, maximum);
    while (code > 0.0 && stored(code - 1.0) >= value)
        code -= 1.0;
    while (code < maximum && stored(code) < value)
        code += 1.0;
    return code;
}

double codeTowardsZero(float value, const ChannelCoding& coding, double maximum) {
    return value < 0.0f ? codeAbove(value, coding, maximum) : codeBelow(value, coding, maximum);
}

auto codeFunction(Rounding rounding) {
    switch (rounding) {
        case Rounding::Down:
            return codeBelow;
        case Rounding::TowardsZero:
            return codeTowardsZero;
        case Rounding::Nearest:
            break;
    }
    return nearestCode;
}

double rounded(double value, Rounding rounding) {
    switch (rounding) {
        case Rounding::Down:
            return std::floor(value);
        case Rounding::TowardsZero:
            return std::trunc(value);
        case Rounding::Nearest:
            break;
    }
    return std::nearbyint(value);
}

/// Rounded to the 11 significant bits of a half (fewer below 2^-14).
float roundToHalf(float value, Rounding rounding) {
    int exponent = 0;
    std::frexp(value, &exponent);
    const double quantum = std::ldexp(1.0, std::max(exponent, -13) - 11);
    return static_cast<float>(rounded(value / quantum, rounding) * quantum);
}

/// Ratios end at the largest half in both float formats, so that infinite ones stay the widest.
float unpackedSample(float value, const ChannelCoding& coding) {
    if (coding.rule.rounding == Rounding::Down)
        value = std::min(value, kLargestHalf);
    return coding.format == StorageFormat::Half ? roundToHalf(value, coding.rule.rounding) : value;
}

}  // namespace

double maximumCode(StorageFormat format) {
    assert(isPackedFormat(format));
    return format == StorageFormat::U16 ? 65535.0 : 255.0;
}

bool isStoredAsRoot(const ChannelRule& rule, StorageFormat format, ConeEncoding encoding) {
    return encoding == ConeEncoding::Sqrt && isPackedFormat(format) && rule.isCone;
}

ChannelCoding channelCoding(std::span<const Plane* const> levels, std::string_view channel,
                            StorageFormat format, ConeEncoding encoding) {
    ChannelCoding coding{format, channelRule(channel), {}, false};
    if (!isPackedFormat(format) || coding.rule.isUnitRange)
        return coding;
    if (coding.rule.rounding == Rounding::TowardsZero)
        coding.range = distanceRange(levels, format);
    else
        coding.range = coding.rule.isSigned ? signedRange(levels, format) : coneRange(levels);
    coding.isRoot = isStoredAsRoot(coding.rule, format, encoding);
    if (coding.isRoot)
        coding.range = {std::sqrt(coding.range.low), std::sqrt(coding.range.high)};
    return coding;
}

void toSamples(const ChannelCoding& coding, std::span<const float> values,
               std::span<float> samples) {
    assert(values.size() == samples.size());
    if (!isPackedFormat(coding.format)) {
        std::transform(values.begin(), values.end(), samples.begin(),
                       [&](float value) { return unpackedSample(value, coding); });
        return;
    }
    const double maximum = maximumCode(coding.format);
    const auto toCode = codeFunction(coding.rule.rounding);
    std::transform(values.begin(), values.end(), samples.begin(),
                   [&](float value) { return static_cast<float>(toCode(value, coding, maximum)); });
}

void toValues(const ChannelCoding& coding, std::span<float> samples) {
    if (!isPackedFormat(coding.format))
        return;
    const double maximum = maximumCode(coding.format);
    for (float& sample : samples)
        sample = static_cast<float>(codeValue(sample, coding, maximum));
}

}  // namespace relievo::textures
