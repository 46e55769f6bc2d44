#include "textures/map_metadata.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "textures/input_error.h"
#include "textures/version.h"

namespace relievo::textures {

namespace {

constexpr std::string_view kPrefix = "relievo:";
constexpr const char* kKind = "relievo:kind";
constexpr const char* kWrap = "relievo:wrap";
constexpr const char* kEncoding = "relievo:encoding";
constexpr const char* kSource = "relievo:source";
constexpr const char* kVersionName = "relievo:version";
constexpr const char* kChannels = "relievo:channels";
constexpr const char* kScale = "relievo:scale";
constexpr std::array kOwn{kKind, kWrap, kEncoding, kSource, kVersionName, kChannels, kScale};

bool isOwn(const std::string& name) {
    return std::find(kOwn.begin(), kOwn.end(), name) != kOwn.end();
}

const std::string& require(const TextAttributes& attributes, const char* name,
                           const std::string& file) {
    const auto found = attributes.find(name);
    if (found == attributes.end())
        throw InputError(fmt::format(
            "{}: lacks the attribute '{}', expected a map file of relievo-bake", file, name));
    return found->second;
}

[[noreturn]] void rejectWord(const std::string& file, const char* name, const std::string& word,
                             const char* expected) {
    throw InputError(
        fmt::format("{}: its attribute '{}' is '{}', expected {}", file, name, word, expected));
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> result;
    for (std::string word; stream >> word;)
        result.push_back(word);
    return result;
}

std::optional<double> number(std::string_view text) {
    double value = 0.0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && stop == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// `low:high` with low < high, not so far apart that the difference is no number.
std::optional<ChannelRange> range(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos)
        return std::nullopt;
    const std::optional<double> low = number(text.substr(0, colon));
    const std::optional<double> high = number(text.substr(colon + 1));
    if (!low || !high || !(*low < *high) || !std::isfinite(*high - *low))
        return std::nullopt;
    return ChannelRange{*low, *high};
}

std::string formatScale(const ChannelRanges& ranges) {
    std::vector<std::string> parts;
    for (const auto& [name, scale] : ranges)
        parts.push_back(fmt::format("{}={}:{}", name, scale.low, scale.high));
    return fmt::format("{}", fmt::join(parts, " "));
}

}  // namespace

TextAttributes describeMaps(const MapSet& maps, const std::vector<std::string>& layout,
                            const ChannelRanges& ranges) {
    TextAttributes attributes;
    for (const auto& [name, value] : maps.attributes) {
        if (!name.starts_with(kPrefix) || isOwn(name))
            throw std::invalid_argument(fmt::format("'{}' cannot be an attribute of a map", name));
        attributes[name] = value;
    }
    attributes[kKind] = maps.kind;
    attributes[kWrap] = wrapModeName(maps.wrap);
    attributes[kEncoding] = coneEncodingName(maps.encoding);
    attributes[kVersionName] = kVersion;
    attributes[kChannels] = fmt::format("{}", fmt::join(layout, " "));
    if (!maps.source.empty())
        attributes[kSource] = maps.source;
    if (!ranges.empty())
        attributes[kScale] = formatScale(ranges);
    return attributes;
}

MapSet mapsFromAttributes(const TextAttributes& attributes, const std::string& file) {
    MapSet maps;
    maps.kind = require(attributes, kKind, file);
    const std::string& wrap = require(attributes, kWrap, file);
    const std::optional<WrapMode> wrapMode = wrapModeFromName(wrap);
    if (!wrapMode)
        rejectWord(file, kWrap, wrap, "repeat, mirror or clamp");
    maps.wrap = *wrapMode;
    const std::string& encoding = require(attributes, kEncoding, file);
    const std::optional<ConeEncoding> coneEncoding = coneEncodingFromName(encoding);
    if (!coneEncoding)
        rejectWord(file, kEncoding, encoding, "ratio, radius or sqrt");
    maps.encoding = *coneEncoding;
    for (const auto& [name, value] : attributes)
        if (name.starts_with(kPrefix) && !isOwn(name))
            maps.attributes[name] = value;
    if (const auto source = attributes.find(kSource); source != attributes.end())
        maps.source = source->second;
    if (const auto version = attributes.find(kVersionName); version != attributes.end())
        maps.version = version->second;
    return maps;
}

std::vector<std::string> layoutFromAttributes(const TextAttributes& attributes,
                                              const std::string& file) {
    const std::string& text = require(attributes, kChannels, file);
    std::vector<std::string> layout = words(text);
    for (auto name = layout.begin(); name != layout.end(); ++name)
        if (*name != kUnusedChannel && std::find(layout.begin(), name, *name) != name)
            rejectWord(file, kChannels, text, "each channel once");
    if (std::all_of(layout.begin(), layout.end(),
                    [](const std::string& name) { return name == kUnusedChannel; }))
        rejectWord(file, kChannels, text, "the names of the channels");
    return layout;
}

ChannelRanges rangesFromAttributes(const TextAttributes& attributes, const std::string& file) {
    const std::string& text = require(attributes, kScale, file);
    ChannelRanges ranges;
    for (const std::string& word : words(text)) {
        const std::size_t equals = word.find('=');
        const std::optional<ChannelRange> scale =
            equals == std::string::npos ? std::nullopt
                                        : range(std::string_view(word).substr(equals + 1));
        if (!scale)
            rejectWord(file, kScale, text, "entries such as dx=-1.5:1.5");
        ranges[word.substr(0, equals)] = *scale;
    }
    return ranges;
}

}  // namespace relievo::textures
