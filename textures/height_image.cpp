#include "textures/height_image.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "textures/content_hash.h"
#include "textures/image_reader.h"
#include "textures/input_error.h"

namespace relievo::textures {

namespace {

/// What the choice of a channel needs to know.
struct Request {
    const std::filesystem::path& file;
    const HeightImageOptions& options;

    [[noreturn]] void reject(std::string_view what) const {
        throw InputError(fmt::format("{}: {}", file.string(), what));
    }
    void note(std::string_view what) const {
        if (options.notice)
            options.notice(fmt::format("{}: {}", file.string(), what));
    }
};

std::optional<int> indexOf(const std::vector<std::string>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? std::nullopt : std::optional<int>(found - names.begin());
}

bool isAlpha(std::string_view name) {
    return name == "A" || name == "Alpha" || name == "alpha";
}

Plane luminance(const Plane& red, const Plane& green, const Plane& blue) {
    Plane result(red.width, red.height);
    for (std::size_t t = 0; t < result.texels.size(); ++t)
        result.texels[t] = static_cast<float>(0.2126 * red.texels[t] + 0.7152 * green.texels[t] +
                                              0.0722 * blue.texels[t]);
    return result;
}

Plane redOrLuminance(ImageReader& reader, const std::array<int, 3>& rgb, const Request& request) {
    const auto [first, last] = std::minmax({rgb[0], rgb[1], rgb[2]});
    const std::vector<Plane> planes = reader.readChannels(first, last - first + 1);
    const Plane& red = planes[static_cast<std::size_t>(rgb[0] - first)];
    const Plane& green = planes[static_cast<std::size_t>(rgb[1] - first)];
    const Plane& blue = planes[static_cast<std::size_t>(rgb[2] - first)];
    if (red.texels == green.texels && red.texels == blue.texels)
        return red;
    request.note(
        "red, green and blue differ: took the Rec. 709 luminance of the stored values; "
        "--channel chooses one of them instead");
    return luminance(red, green, blue);
}

Plane readChosenChannel(ImageReader& reader, const Request& request) {
    const std::vector<std::string>& names = reader.info().channelNames;
    const auto only = [&](int channel) { return reader.readChannels(channel, 1).front(); };
    if (!request.options.channel.empty())
        return only(reader.channelIndex(request.options.channel));
    if (std::count_if(names.begin(), names.end(), std::not_fn(isAlpha)) == 1)
        return only(static_cast<int>(std::find_if_not(names.begin(), names.end(), isAlpha) -
                                     names.begin()));
    if (names.size() == 1)
        return only(0);
    if (const std::optional<int> y = indexOf(names, "Y"))
        return only(*y);
    const auto red = indexOf(names, "R"), green = indexOf(names, "G"), blue = indexOf(names, "B");
    if (!red || !green || !blue)
        request.reject(
            fmt::format("has the channels {}, expected Y, or R, G and B; --channel says "
                        "which one is meant",
                        fmt::join(names, ", ")));
    return redOrLuminance(reader, {*red, *green, *blue}, request);
}

/// The texels for which `bad` holds: how many, and the first.
template <class Predicate>
void rejectTexels(const Plane& plane, const Request& request, Predicate bad, const char* sentence) {
    const auto count = std::count_if(plane.texels.begin(), plane.texels.end(), bad);
    if (count == 0)
        return;
    const auto first =
        std::find_if(plane.texels.begin(), plane.texels.end(), bad) - plane.texels.begin();
    request.reject(
        fmt::format(fmt::runtime(sentence), count, first % plane.width, first / plane.width));
}

void checkValues(const Plane& plane, const Request& request) {
    rejectTexels(
        plane, request, [](float x) { return !std::isfinite(x); },
        "has {} values that are NaN or infinite (the first at texel {},{}), expected finite ones");
    const auto [low, high] = std::minmax_element(plane.texels.begin(), plane.texels.end());
    if (*low < 0.0f || *high > 1.0f)
        request.reject(fmt::format(
            "has values from {} to {}, expected 0 to 1: normalise it to [0,1]", *low, *high));
}

}  // namespace

HeightImage readHeightImage(const std::filesystem::path& file, const HeightImageOptions& options) {
    const Request request{file, options};
    ImageReader reader(file);
    if (reader.info().orientation != 1)
        request.note(
            fmt::format("asks viewers to turn or flip it (orientation {}): taken as stored",
                        reader.info().orientation));
    HeightImage image;
    image.depth.wrap = options.wrap;
    image.depth.depth = readChosenChannel(reader, request);
    Plane& values = image.depth.depth;
    checkValues(values, request);
    if (!options.isDepth)
        std::transform(values.texels.begin(), values.texels.end(), values.texels.begin(),
                       [](float height) { return 1.0f - height; });
    image.source = contentHash(values);
    return image;
}

}  // namespace relievo::textures
