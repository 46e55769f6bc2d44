#include "preprocess/verify_input.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "commands/program.h"
#include "preprocess/cone_encoding.h"
#include "textures/cone_layers.h"
#include "textures/height_image.h"
#include "textures/image_reader.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "textures/roof_layers.h"

namespace relievo::preprocess {
namespace {

using commands::UsageError;
using reference::ConePromise;
using textures::InputError;
using textures::Plane;

constexpr const char* kConservative = "conservative";

ConePromise promiseOf(const std::string& kind) {
    return kind == "relaxed" ? ConePromise::Relaxed : ConePromise::Conservative;
}

std::string orElse(const std::string& word, const char* otherwise) {
    return word.empty() ? otherwise : word;
}

// The attribute `name` of `maps`, or `otherwise` when it has none.
std::string attributeOf(const textures::MapSet& maps, const std::string& name,
                        const std::string& otherwise) {
    const auto found = maps.attributes.find(name);
    return found == maps.attributes.end() ? otherwise : found->second;
}

std::string describeRoofs(const reference::RoofMap& roofs) {
    const std::size_t sectors = roofs.layers.size();
    return fmt::format("roof cones in {} {}", sectors, sectors == 1 ? "sector" : "sectors");
}

std::string describeSurfaceCones(const std::string& kind, std::size_t sectors) {
    return sectors == 1 ? kind + " cones" : fmt::format("{} cones in {} sectors", kind, sectors);
}

std::vector<ConesToVerify> surfaceConesOf(const textures::MapSet& maps,
                                          const textures::DepthMap& relief) {
    const std::vector<const Plane*> layers = textures::coneLayersOf(maps);
    if (layers.empty())
        return {};
    const std::string kind = attributeOf(maps, "relievo:cone", kConservative);
    SurfaceCones cones{{}, promiseOf(kind)};
    for (const Plane* layer : layers)
        cones.ratios.push_back(decodeCones(*layer, relief.depth, maps.encoding));
    return {{describeSurfaceCones(kind, layers.size()), relief, std::move(cones)}};
}

std::vector<ConesToVerify> roofConesOf(const textures::MapSet& maps,
                                       const textures::DepthMap& relief) {
    const textures::RoofLayers found = textures::roofLayersOf(maps);
    if (found.layers.empty())
        return {};
    reference::RoofMap roofs;
    for (const textures::RoofLayer& layer : found.layers)
        roofs.layers.push_back({*layer.roof, *layer.ratio});
    roofs.block = found.block;
    return {{describeRoofs(roofs), relief, std::move(roofs)}};
}

std::vector<ConesToVerify> conesOfLevel(const textures::MapSet& maps, const std::string& file) try {
    const textures::DepthMap relief = textures::depthMapOf(maps);
    std::vector<ConesToVerify> all = surfaceConesOf(maps, relief);
    std::ranges::move(roofConesOf(maps, relief), std::back_inserter(all));
    if (all.empty())
        throw InputError("holds no cones, expected the channel 'cone', 'cone0', 'roof' or 'roof0'");
    return all;
} catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
}

std::vector<ConesToVerify> conesOfMapFile(const VerifyArguments& arguments) {
    refuseOptionsOfOtherTools(arguments);
    const std::vector<textures::MapSet> levels = textures::readMapLevels(arguments.file);
    std::vector<ConesToVerify> all;
    for (std::size_t level = 0; level < levels.size(); ++level)
        for (ConesToVerify& cones : conesOfLevel(levels[level], arguments.file)) {
            if (level > 0)
                cones.description += fmt::format(" of level {}", level);
            all.push_back(std::move(cones));
        }
    return all;
}

void checkValues(const Plane& plane, const std::string& file) {
    const auto bad = std::find_if(plane.texels.begin(), plane.texels.end(),
                                  [](float value) { return !(value >= 0.0f); });
    if (bad == plane.texels.end())
        return;
    const auto texel = static_cast<int>(bad - plane.texels.begin());
    throw InputError(fmt::format("{}: has the value {} at texel {},{}, expected values from 0",
                                 file, *bad, texel % plane.width, texel / plane.width));
}

// The channel called `channel`, or the only one.
Plane readChannel(const std::string& file, const std::string& channel, const char* option) {
    textures::ImageReader reader(file);
    const std::size_t channels = reader.info().channelNames.size();
    if (channel.empty() && channels > 1)
        throw UsageError(
            fmt::format("{}: is no map file of relievo-bake and has {} channels, so "
                        "{} must say which one is meant",
                        file, channels, option));
    const int index = channel.empty() ? 0 : reader.channelIndex(channel);
    Plane plane = std::move(reader.readChannels(index, 1).front());
    checkValues(plane, file);
    return plane;
}

Plane readRatios(const VerifyArguments& arguments) {
    Plane ratio = readChannel(arguments.file, arguments.coneChannel, "--cone-channel");
    const auto scale = static_cast<float>(arguments.coneScale.value_or(1.0));
    for (float& value : ratio.texels)
        value *= scale;
    return ratio;
}

textures::DepthMap readDepths(const VerifyArguments& arguments) {
    if (arguments.depthFile.empty() && arguments.depthChannel.empty())
        throw UsageError(fmt::format(
            "{}: is no map file of relievo-bake, so --depth-channel or --depth must say "
            "where the depths are",
            arguments.file));
    textures::HeightImageOptions options;
    options.isDepth = arguments.input == "depth";
    options.channel = arguments.depthChannel;
    options.wrap = *textures::wrapModeFromName(orElse(arguments.wrap, "repeat"));
    options.notice = commands::note;
    return textures::readHeightImage(
               arguments.depthFile.empty() ? arguments.file : arguments.depthFile, options)
        .depth;
}

std::vector<ConesToVerify> conesOfOtherTool(const VerifyArguments& arguments) {
    const std::string kind = orElse(arguments.kind, kConservative);
    const bool isRoof = kind == "roof";
    if (isRoof == arguments.roofChannel.empty())
        throw UsageError("--kind roof and --roof-channel go together");
    if (isRoof && !arguments.encoding.empty())
        throw UsageError("--encode: roof cones are ratios");
    textures::DepthMap relief = readDepths(arguments);
    Plane ratio = readRatios(arguments);
    if (ratio.width != relief.width() || ratio.height != relief.height())
        throw InputError(fmt::format("{}: has {}×{} cones, expected {}×{} like the depths in {}",
                                     arguments.file, ratio.width, ratio.height, relief.width(),
                                     relief.height(), arguments.depthFile));
    if (isRoof) {
        Plane roof = readChannel(arguments.file, arguments.roofChannel, "--roof-channel");
        reference::RoofMap roofs{{{std::move(roof), std::move(ratio)}}, 1};
        return {{describeRoofs(roofs), std::move(relief), std::move(roofs)}};
    }
    const textures::ConeEncoding encoding =
        *textures::coneEncodingFromName(orElse(arguments.encoding, "ratio"));
    SurfaceCones cones{{decodeCones(ratio, relief.depth, encoding)}, promiseOf(kind)};
    return {{describeSurfaceCones(kind, 1), std::move(relief), std::move(cones)}};
}

}  // namespace

void refuseOptionsOfOtherTools(const VerifyArguments& arguments) {
    const std::pair<const char*, bool> given[] = {
        {"--depth", !arguments.depthFile.empty()},
        {"--depth-channel", !arguments.depthChannel.empty()},
        {"--cone-channel", !arguments.coneChannel.empty()},
        {"--roof-channel", !arguments.roofChannel.empty()},
        {"--kind", !arguments.kind.empty()},
        {"--encode", !arguments.encoding.empty()},
        {"--wrap", !arguments.wrap.empty()},
        {"--input", !arguments.input.empty()},
        {"--cone-scale", arguments.coneScale.has_value()},
    };
    for (const auto& [option, isGiven] : given)
        if (isGiven)
            throw UsageError(
                fmt::format("{}: is a map file of relievo-bake, which describes itself; {} is for "
                            "files of other tools",
                            arguments.file, option));
}

std::vector<ConesToVerify> readConesToVerify(const VerifyArguments& arguments) {
    return textures::isMapFile(arguments.file) ? conesOfMapFile(arguments)
                                               : conesOfOtherTool(arguments);
}

}  // namespace relievo::preprocess
