#include "preprocess/verify_input.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "commands/program.h"
#include "preprocess/cone_encoding.h"
#include "textures/height_image.h"
#include "textures/image_reader.h"
#include "textures/input_error.h"
#include "textures/map_file.h"

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

// A map file says itself what these options say; to have them contradict it helps nobody.
void refuseOptionsOfOtherTools(const VerifyArguments& arguments) {
    const std::pair<const char*, bool> given[] = {
        {"--depth", !arguments.depthFile.empty()},
        {"--depth-channel", !arguments.depthChannel.empty()},
        {"--cone-channel", !arguments.coneChannel.empty()},
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

std::vector<ConesToVerify> conesOfMapFile(const VerifyArguments& arguments) {
    refuseOptionsOfOtherTools(arguments);
    const textures::MapSet maps = textures::readMapFile(arguments.file);
    const Plane* cone = maps.find("cone");
    if (cone == nullptr)
        throw InputError(
            fmt::format("{}: holds no cones, expected the channel 'cone'", arguments.file));
    textures::DepthMap relief;
    try {
        relief = textures::depthMapOf(maps);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", arguments.file, error.what()));
    }
    const auto named = maps.attributes.find("relievo:cone");
    const std::string kind = named == maps.attributes.end() ? kConservative : named->second;
    Plane ratio = decodeCones(*cone, relief.depth, maps.encoding);
    return {{kind + " cones", std::move(relief), std::move(ratio), promiseOf(kind)}};
}

void checkConeValues(const Plane& cone, const std::string& file) {
    const auto bad = std::find_if(cone.texels.begin(), cone.texels.end(),
                                  [](float value) { return !(value >= 0.0f); });
    if (bad == cone.texels.end())
        return;
    const auto texel = static_cast<int>(bad - cone.texels.begin());
    throw InputError(fmt::format("{}: has the cone {} at texel {},{}, expected values from 0", file,
                                 *bad, texel % cone.width, texel / cone.width));
}

Plane readConeChannel(const VerifyArguments& arguments) {
    textures::ImageReader reader(arguments.file);
    const std::size_t channels = reader.info().channelNames.size();
    if (arguments.coneChannel.empty() && channels > 1)
        throw UsageError(
            fmt::format("{}: is no map file of relievo-bake and has {} channels, so --cone-channel "
                        "must say which one holds the cones",
                        arguments.file, channels));
    const int channel =
        arguments.coneChannel.empty() ? 0 : reader.channelIndex(arguments.coneChannel);
    Plane cone = std::move(reader.readChannels(channel, 1).front());
    const auto scale = static_cast<float>(arguments.coneScale.value_or(1.0));
    for (float& value : cone.texels)
        value *= scale;
    checkConeValues(cone, arguments.file);
    return cone;
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
    textures::DepthMap relief = readDepths(arguments);
    const Plane cone = readConeChannel(arguments);
    if (cone.width != relief.width() || cone.height != relief.height())
        throw InputError(fmt::format("{}: has {}×{} cones, expected {}×{} like the depths in {}",
                                     arguments.file, cone.width, cone.height, relief.width(),
                                     relief.height(), arguments.depthFile));
    const std::string kind = orElse(arguments.kind, kConservative);
    Plane ratio = decodeCones(cone, relief.depth,
                              *textures::coneEncodingFromName(orElse(arguments.encoding, "ratio")));
    return {{kind + " cones", std::move(relief), std::move(ratio), promiseOf(kind)}};
}

}  // namespace

std::vector<ConesToVerify> readConesToVerify(const VerifyArguments& arguments) {
    return textures::isMapFile(arguments.file) ? conesOfMapFile(arguments)
                                               : conesOfOtherTool(arguments);
}

}  // namespace relievo::preprocess
