#include "textures/map_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "textures/channel_coding.h"
#include "textures/channel_rules.h"
#include "textures/file_extension.h"
#include "textures/image_reader.h"
#include "textures/image_writer.h"
#include "textures/input_error.h"
#include "textures/map_metadata.h"

namespace relievo::textures {

namespace {

constexpr std::array<std::string_view, 4> kThesisChannels{"dx", "dy", "cone", "depth"};
/// The one text field that TIFF keeps: it holds the attributes as a JSON object.
constexpr const char* kDescription = "ImageDescription";

void checkChannels(const MapSet& maps) {
    std::set<std::string_view> names;
    if (maps.width() < 1 || maps.height() < 1)
        throw std::invalid_argument("a map file needs at least one channel of at least one texel");
    for (const Channel& channel : maps.channels) {
        if (channel.plane.width != maps.width() || channel.plane.height != maps.height())
            throw std::invalid_argument("the channels of a map file must be of one size");
        const bool isWord = channel.name.find_first_of(" \t\n=") == std::string::npos;
        if (channel.name.empty() || channel.name == kUnusedChannel || !isWord ||
            !names.insert(channel.name).second)
            throw std::invalid_argument("'" + channel.name +
                                        "' cannot name a channel, or names two");
    }
}

/// Ratios may be infinite (stored as the widest), nothing may be NaN, and halves end at 65504.
void checkStorable(const std::filesystem::path& file, const Channel& channel,
                   StorageFormat format) {
    const bool mayBeInfinite = channelRule(channel.name).rounding == Rounding::Down;
    const float largest =
        format == StorageFormat::Half ? kLargestHalf : std::numeric_limits<float>::max();
    for (const float value : channel.plane.texels)
        if (std::isnan(value) || (std::abs(value) > largest && !(mayBeInfinite && value > 0.0f)))
            throw InputError(fmt::format("{}: channel '{}' has the value {}, which {} cannot hold",
                                         file.string(), channel.name, value,
                                         storageFormatName(format)));
}

/// Which channel lies where in a packed file. Grey and RGB(A) only: two channels would be read as
/// grey and alpha.
std::vector<std::string> packedLayout(const std::filesystem::path& file, const MapSet& maps) {
    const bool isThesisForm =
        std::all_of(maps.channels.begin(), maps.channels.end(), [](const Channel& channel) {
            return std::find(kThesisChannels.begin(), kThesisChannels.end(), channel.name) !=
                   kThesisChannels.end();
        });
    std::vector<std::string> layout;
    if (isThesisForm && maps.channels.size() > 1) {
        for (const std::string_view name : kThesisChannels)
            layout.emplace_back(maps.find(name) != nullptr ? name : kUnusedChannel);
        if (layout.back() == kUnusedChannel)
            layout.pop_back();
    } else {
        for (const Channel& channel : maps.channels)
            layout.push_back(channel.name);
        if (layout.size() == 2)
            layout.emplace_back(kUnusedChannel);
    }
    if (layout.size() > 4)
        throw InputError(fmt::format(
            "{}: a packed file cannot hold {} channels, expected at most 4 (or an .exr file)",
            file.string(), layout.size()));
    return layout;
}

/// The rows of a channel as they are stored. `values` is null for a channel that holds nothing.
RowSource rowsOf(const Plane* values, const ChannelCoding& coding) {
    if (values == nullptr)
        return [](int, std::span<float> samples) { std::ranges::fill(samples, 0.0f); };
    return [values, coding](int row, std::span<float> samples) {
        toSamples(coding, {&values->texels[values->index(0, row)], samples.size()}, samples);
    };
}

/// Everything about a map file but its samples, and where these come from.
struct MapFileContent {
    ImageDescription description;
    std::vector<ImageLevel> levels;
};

/// The channel called `name` in all levels; one range serves them all, as one texture does.
void addChannel(const std::string& name, std::span<const MapSet> levels, ChannelRanges& ranges,
                MapFileContent& content) {
    std::vector<const Plane*> planes;
    for (const MapSet& level : levels)
        planes.push_back(level.find(name));
    const StorageFormat format = content.description.format;
    ChannelCoding coding;
    if (planes.front() != nullptr)
        coding = channelCoding(planes, name, format, levels.front().encoding);
    if (planes.front() != nullptr && isPackedFormat(format))
        ranges[name] = coding.range;
    for (std::size_t k = 0; k < levels.size(); ++k)
        content.levels[k].channels.push_back(rowsOf(planes[k], coding));
}

MapFileContent contentOf(const std::filesystem::path& file, std::span<const MapSet> levels,
                         StorageFormat format) {
    const MapSet& maps = levels.front();
    const bool isPacked = isPackedFormat(format);
    std::vector<std::string> layout;
    if (isPacked)
        layout = packedLayout(file, maps);
    else
        for (const Channel& channel : maps.channels)
            layout.push_back(channel.name);
    MapFileContent content{{{}, format, {}, false}, {}};
    for (const MapSet& level : levels)
        content.levels.push_back({level.width(), level.height(), {}});
    ChannelRanges ranges;
    for (const std::string& name : layout)
        addChannel(name, levels, ranges, content);
    content.description.attributes = describeMaps(maps, layout, ranges);
    if (!isPacked)
        content.description.channelNames = layout;
    else if (lowerExtension(file) != ".png")
        content.description.attributes = {
            {kDescription, nlohmann::json(content.description.attributes).dump()}};
    return content;
}

/// Mistakes of the caller.
void checkLevels(std::span<const MapSet> levels) {
    if (levels.empty())
        throw std::invalid_argument("a map file needs at least one level");
    for (std::size_t k = 0; k < levels.size(); ++k) {
        checkChannels(levels[k]);
        if (k == 0)
            continue;
        const MapSet& before = levels[k - 1];
        const bool isHalf = levels[k].width() == std::max(before.width() / 2, 1) &&
                            levels[k].height() == std::max(before.height() / 2, 1);
        const bool hasSameChannels = std::ranges::equal(levels[k].channels, before.channels, {},
                                                        &Channel::name, &Channel::name);
        if (!isHalf || !hasSameChannels)
            throw std::invalid_argument("a level must halve the one before, channel by channel");
    }
    const MapSet& last = levels.back();
    if (levels.size() > 1 && (last.width() > 1 || last.height() > 1))
        throw std::invalid_argument("levels must go down to one texel");
}

TextAttributes attributesOf(const ImageInfo& info) {
    TextAttributes attributes = info.attributes;
    if (const auto description = attributes.find(kDescription); description != attributes.end()) {
        const auto json = nlohmann::json::parse(description->second, nullptr, false);
        if (json.is_object())
            for (const auto& [name, value] : json.items())
                if (value.is_string())
                    attributes[name] = value.get<std::string>();
    }
    return attributes;
}

StorageFormat formatOf(const ImageInfo& info, const std::string& file) {
    switch (info.type) {
        case SampleType::U8:
            return StorageFormat::U8;
        case SampleType::U16:
            return StorageFormat::U16;
        case SampleType::Half:
            return StorageFormat::Half;
        case SampleType::Float:
            return StorageFormat::Float;
        case SampleType::Other:
            break;
    }
    throw InputError(file +
                     ": has a number format that map files do not use, expected 8 or 16-bit "
                     "integers, half or float");
}

void checkValues(const Channel& channel, const std::string& file) {
    const ChannelRule rule = channelRule(channel.name);
    const float low = rule.isSigned ? std::numeric_limits<float>::lowest() : 0.0f;
    const float high = rule.isUnitRange ? 1.0f : std::numeric_limits<float>::max();
    const auto bad = std::find_if(channel.plane.texels.begin(), channel.plane.texels.end(),
                                  [&](float value) { return !(value >= low && value <= high); });
    if (bad != channel.plane.texels.end())
        throw InputError(fmt::format(
            "{}: its channel '{}' has the value {}, expected {}", file, channel.name, *bad,
            rule.isUnitRange ? "0 to 1"
                             : (rule.isSigned ? "finite values" : "finite values from 0")));
}

/// Turns the codes of the channel `name`, as fractions of the largest, into values.
void unpack(Plane& stored, const std::string& name, const ChannelRanges& ranges,
            StorageFormat format, ConeEncoding encoding, const std::string& file) {
    const auto range = ranges.find(name);
    if (range == ranges.end())
        throw InputError(
            fmt::format("{}: its attribute 'relievo:scale' lacks the channel '{}'", file, name));
    const ChannelRule rule = channelRule(name);
    for (float& value : stored.texels)
        value = static_cast<float>(std::nearbyint(value * maximumCode(format)));
    toValues({format, rule, range->second, isStoredAsRoot(rule, format, encoding)}, stored.texels);
}

void unpackChannels(std::vector<Plane> planes, const std::vector<std::string>& layout,
                    const ChannelRanges& ranges, StorageFormat format, const std::string& file,
                    MapSet& maps) {
    if (planes.size() != layout.size())
        throw InputError(fmt::format("{}: has {} channels, expected the {} of 'relievo:channels'",
                                     file, planes.size(), layout.size()));
    for (std::size_t c = 0; c < layout.size(); ++c)
        if (layout[c] != kUnusedChannel) {
            unpack(planes[c], layout[c], ranges, format, maps.encoding, file);
            maps.channels.push_back({layout[c], std::move(planes[c])});
        }
}

/// EXR channels come in an order of the library's choice: they are found by name.
void takeNamedChannels(std::vector<Plane> planes, const std::vector<std::string>& stored,
                       const std::vector<std::string>& layout, const std::string& file,
                       MapSet& maps) {
    for (const std::string& name : layout) {
        const auto found = std::find(stored.begin(), stored.end(), name);
        if (found == stored.end())
            throw InputError(fmt::format(
                "{}: lacks the channel '{}', which 'relievo:channels' names", file, name));
        maps.channels.push_back(
            {name, std::move(planes[static_cast<std::size_t>(found - stored.begin())])});
    }
}

/// A map file whose metadata makes sense.
class MapFileReader {
  public:
    explicit MapFileReader(const std::filesystem::path& file)
        : name_(file.string()),
          reader_(file, kLargestMap),
          attributes_(attributesOf(reader_.info())),
          description_(mapsFromAttributes(attributes_, name_)),
          layout_(layoutFromAttributes(attributes_, name_)),
          format_(formatOf(reader_.info(), name_)) {}

    [[nodiscard]] std::size_t levelCount() const { return reader_.info().levels.size(); }

    [[nodiscard]] MapSet read(std::size_t level) {
        const ImageInfo& info = reader_.info();
        MapSet maps = description_;
        const LevelSize size = info.levels.at(level);
        // The tile has the aspect of the first level, whose texels are squares.
        maps.texelAspect =
            level == 0 ? 1.0
                       : static_cast<double>(info.height) / info.width * size.width / size.height;
        std::vector<Plane> planes =
            reader_.readChannels(0, static_cast<int>(info.channelNames.size()), level);
        if (isPackedFormat(format_))
            unpackChannels(std::move(planes), layout_, rangesFromAttributes(attributes_, name_),
                           format_, name_, maps);
        else
            takeNamedChannels(std::move(planes), info.channelNames, layout_, name_, maps);
        for (const Channel& channel : maps.channels)
            checkValues(channel, name_);
        return maps;
    }

    [[nodiscard]] MapSet readDescription() {
        reader_.requireEnd();
        return description_;
    }

  private:
    std::string name_;
    ImageReader reader_;
    TextAttributes attributes_;
    MapSet description_;
    std::vector<std::string> layout_;
    StorageFormat format_;
};

}  // namespace

void requireReadableSize(const std::filesystem::path& file, int width, int height,
                         std::size_t channels) {
    const double texels = 1.0 * width * height;
    if (texels * static_cast<double>(channels * sizeof(float)) > kLargestMap)
        throw InputError(fmt::format(
            "{}: {} x {} texels with {} channels are too many for a map file, expected at most "
            "{} GiB as floats",
            file.string(), width, height, channels, kLargestMap / (1024.0 * 1024.0 * 1024.0)));
}

void writeMapFile(const std::filesystem::path& file, std::span<const MapSet> levels,
                  StorageFormat format) {
    checkLevels(levels);
    requireExtensionFor(file, format);
    if (levels.size() > 1 && lowerExtension(file) == ".png")
        throw InputError(file.string() +
                         ": a PNG file holds no MIP levels, expected .exr or .tif for them");
    const MapSet& maps = levels.front();
    requireReadableSize(file, maps.width(), maps.height(), maps.channels.size());
    for (const MapSet& level : levels)
        for (const Channel& channel : level.channels)
            checkStorable(file, channel, format);
    const MapFileContent content = contentOf(file, levels, format);
    writeImage(file, content.description, content.levels);
}

void writeMapFile(const std::filesystem::path& file, const MapSet& maps, StorageFormat format) {
    writeMapFile(file, std::span(&maps, 1), format);
}

bool isMapFile(const std::filesystem::path& file) {
    const TextAttributes attributes = attributesOf(ImageReader(file, kLargestMap).info());
    return std::any_of(attributes.begin(), attributes.end(), [](const auto& attribute) {
        return attribute.first.starts_with("relievo:");
    });
}

MapSet readMapFile(const std::filesystem::path& file) {
    return MapFileReader(file).read(0);
}

std::vector<MapSet> readMapLevels(const std::filesystem::path& file) {
    MapFileReader reader(file);
    std::vector<MapSet> levels;
    for (std::size_t k = 0; k < reader.levelCount(); ++k)
        levels.push_back(reader.read(k));
    return levels;
}

MapSet readMapDescription(const std::filesystem::path& file) {
    return MapFileReader(file).readDescription();
}

}  // namespace relievo::textures
