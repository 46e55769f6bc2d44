#include "preprocess/info_command.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "commands/program.h"
#include "textures/channel_rules.h"
#include "textures/image_reader.h"
#include "textures/map_file.h"

namespace relievo::preprocess {
namespace {

// Keeps the order in which things are said.
using Json = nlohmann::ordered_json;

const char* typeName(textures::SampleType type) {
    switch (type) {
        case textures::SampleType::U8:
            return "u8";
        case textures::SampleType::U16:
            return "u16";
        case textures::SampleType::Half:
            return "half";
        case textures::SampleType::Float:
            return "float";
        case textures::SampleType::Other:
            break;
    }
    return "other";
}

// Least, greatest and mean value; of cones without the unlimited ones, which are counted.
Json describeChannel(const textures::Channel& channel) {
    const bool isCone = textures::channelRule(channel.name).rounding == textures::Rounding::Down;
    std::vector<float> values = channel.plane.texels;
    if (isCone)
        std::erase_if(values, [](float value) { return value >= textures::kLargestHalf; });
    Json description{{"name", channel.name}};
    if (!values.empty()) {
        const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
        double sum = 0.0;
        for (const float value : values)
            sum += value;
        description["min"] = *least;
        description["max"] = *greatest;
        description["mean"] = sum / static_cast<double>(values.size());
    }
    if (isCone)
        description["unlimited"] = channel.plane.texels.size() - values.size();
    return description;
}

Json describeImage(const std::string& file) {
    textures::ImageReader reader(file);
    const textures::ImageInfo& info = reader.info();
    Json description{{"file", file},
                     {"kind", "image"},
                     {"width", info.width},
                     {"height", info.height},
                     {"format", typeName(info.type)}};
    const std::vector<textures::Plane> planes =
        reader.readChannels(0, static_cast<int>(info.channelNames.size()));
    for (std::size_t c = 0; c < planes.size(); ++c)
        description["channels"].push_back(describeChannel({info.channelNames[c], planes[c]}));
    return description;
}

Json describeMaps(const std::string& file) {
    const textures::MapSet maps = textures::readMapFile(file);
    const textures::ImageInfo header = textures::ImageReader(file, textures::kLargestMap).info();
    Json description{{"file", file},
                     {"kind", maps.kind},
                     {"width", maps.width()},
                     {"height", maps.height()},
                     {"format", typeName(header.type)},
                     {"wrap", textures::wrapModeName(maps.wrap)}};
    if (header.levels.size() > 1)
        for (const auto& [width, height] : header.levels)
            description["levels"].push_back(fmt::format("{}x{}", width, height));
    if (maps.find("cone") != nullptr || maps.find("cone0") != nullptr)
        description["encoding"] = textures::coneEncodingName(maps.encoding);
    description["source"] = maps.source;
    description["version"] = maps.version;
    for (const auto& [name, value] : maps.attributes)
        description["attributes"][name] = value;
    for (const textures::Channel& channel : maps.channels)
        description["channels"].push_back(describeChannel(channel));
    return description;
}

std::string textOf(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

// Tables in an attribute are for programs.
std::string shortened(const std::string& text) {
    constexpr std::size_t kLongest = 200;
    constexpr std::size_t kShown = 40;
    return text.size() <= kLongest
               ? text
               : fmt::format("{}... ({} characters)", text.substr(0, kShown), text.size());
}

void printChannel(const Json& channel) {
    std::string line = fmt::format("{:<10}", channel["name"].get<std::string>());
    for (const char* key : {"min", "max", "mean"})
        if (channel.contains(key))
            line += fmt::format(" {} {:<12.6g}", key, channel[key].get<double>());
    if (channel.contains("unlimited"))
        line += fmt::format(" unlimited {}", channel["unlimited"].get<std::size_t>());
    commands::answer("  " + line);
}

void print(const Json& description) {
    for (const auto& [key, value] : description.items())
        if (key == "channels")
            std::for_each(value.begin(), value.end(), printChannel);
        else if (key == "attributes")
            for (const auto& [name, word] : value.items())
                commands::answer(fmt::format("{:<22} {}", name, shortened(textOf(word))));
        else if (key == "levels")
            commands::answer(fmt::format("{:<10} {} down to 1x1", key, value.size()));
        else
            commands::answer(fmt::format("{:<10} {}", key, textOf(value)));
}

}  // namespace

CLI::App* addInfoCommand(CLI::App& app, InfoArguments& arguments) {
    CLI::App* command = app.add_subcommand("info", "Say what a map file or an image holds");
    command->add_option("FILE", arguments.file, "Map file or image")->required();
    command->add_flag("--json", arguments.json, "As JSON, for scripts");
    command->footer("Example:\n  relievo-bake info bricks.exr --json");
    return command;
}

void runInfoCommand(const InfoArguments& arguments) {
    const Json description = textures::isMapFile(arguments.file) ? describeMaps(arguments.file)
                                                                 : describeImage(arguments.file);
    if (arguments.json)
        commands::answer(description.dump(2));
    else
        print(description);
}

}  // namespace relievo::preprocess
