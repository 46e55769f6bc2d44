#include "preprocess/shape_command.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <variant>

#include "commands/program.h"
#include "commands/progress.h"
#include "preprocess/command_options.h"
#include "preprocess/memory_need.h"
#include "preprocess/shape_baker.h"
#include "textures/atomic_file.h"
#include "textures/file_extension.h"
#include "textures/image_reader.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "textures/version.h"

namespace relievo::preprocess {
namespace {

using commands::UsageError;
using textures::MapSet;
using textures::ShapeMap;

constexpr double kProgramBytes = 150e6;
// Coverage, centres, four channels, squared distances or a copy of the distances, and the outline:
// that of a picture of noise takes more than all these together.
constexpr double kTexelBytes = 48.0;
// Creases: their two channels, as they are baked and as they are written.
constexpr double kCreaseBytes = 16.0;
constexpr double kNoiseBytes = 200.0;

bool exists(const std::string& file) {
    std::error_code none;
    return std::filesystem::exists(file, none);
}

bool isDrawing(const std::string& source) {
    return !exists(source) || textures::lowerExtension(source) == ".svg";
}

ShapePlan planOf(const ShapeArguments& arguments) {
    ShapePlan plan;
    plan.wrap = *textures::wrapModeFromName(arguments.wrap);
    plan.isWhiteInside = arguments.inside == "white";
    if (arguments.isSigned && arguments.isUnsigned)
        throw UsageError("--signed and --unsigned exclude each other");
    plan.isSigned = !arguments.isUnsigned;
    plan.gradient = arguments.gradient == "exact" ? 0 : arguments.gradient.front() - '0';
    plan.channel = arguments.channel;
    plan.format = outputFormat(arguments.output, arguments.format);
    plan.hasSharpCorners = arguments.corners != "round";
    if (arguments.corners == "sharp" && !plan.hasCreases())
        throw UsageError("--corners sharp: is for signed distances in .exr files");
    if (!arguments.size.empty()) {
        const MapSize size = parseSize(arguments.size, kLargestShape);
        plan.width = size.width;
        plan.height = size.height;
    }
    std::error_code missing;
    if (std::filesystem::equivalent(arguments.source, arguments.output, missing))
        throw UsageError(fmt::format("-o {}: is the source itself", arguments.output));
    if (!isDrawing(arguments.source) && !arguments.size.empty())
        throw UsageError("--size: is for drawings and text, an image has a size of its own");
    if (isDrawing(arguments.source) && !arguments.channel.empty())
        throw UsageError("--channel: is for images, drawings and text have none");
    return plan;
}

// How many neighbouring texels of a row lie on different sides of the outline, as a share.
double outlineShare(const textures::Plane& coverage) {
    std::size_t changes = 0;
    for (std::size_t t = 1; t < coverage.texels.size(); ++t)
        changes += (coverage.texels[t] >= 0.5f) != (coverage.texels[t - 1] >= 0.5f) ? 1 : 0;
    return static_cast<double>(changes) / static_cast<double>(coverage.texels.size());
}

void requireRoom(const ShapeArguments& arguments, const ShapePlan& plan, int width, int height,
                 double outlineBytes) {
    textures::requireReadableSize(arguments.output, width, height, plan.hasCreases() ? 6 : 4);
    const double bytes = kTexelBytes + (plan.hasCreases() ? kCreaseBytes : 0.0) + outlineBytes;
    const double need = kProgramBytes + bytes * width * height;
    const auto available = static_cast<double>(availableMemory());
    if (need > available)
        throw textures::InputError(fmt::format(
            "{}: its map of {} x {} texels takes {} of memory to bake, but {} are available",
            arguments.source, width, height, memoryText(need), memoryText(available)));
}

ShapeSource readSource(const ShapeArguments& arguments, const ShapePlan& plan) {
    const Stage stage("read");
    ShapeSource source = readShapeSource(arguments.source, plan, commands::note);
    double outlineBytes = 0.0;
    std::string what = "bitmap";
    if (const auto* coverage = std::get_if<textures::Plane>(&source.content)) {
        outlineBytes = kNoiseBytes * outlineShare(*coverage);
    } else {
        const auto& drawing = std::get<outlines::Drawing>(source.content);
        std::size_t points = 0;
        for (const outlines::Outline& outline : drawing.shapes)
            for (const outlines::Contour& contour : outline.contours)
                points += contour.size();
        what = fmt::format("{} shapes of {} points", drawing.shapes.size(), points);
    }
    requireRoom(arguments, plan, source.width, source.height, outlineBytes);
    stage.done(fmt::format("{}, {}, {}×{}, {}", arguments.source, what, source.width, source.height,
                           arguments.wrap));
    return source;
}

// Whether the output is there, whole, and made of the same source by the same options and version.
bool isUpToDate(const ShapeArguments& arguments, const ShapePlan& plan, const ShapeSource& source) {
    if (!exists(arguments.output))
        return false;
    try {
        const MapSet old = textures::readMapDescription(arguments.output);
        const textures::ImageInfo info =
            textures::ImageReader(arguments.output, textures::kLargestMap).info();
        const auto options = old.attributes.find("relievo:options");
        return old.source == source.hash && old.wrap == plan.wrap &&
               old.version == textures::kVersion && options != old.attributes.end() &&
               options->second == optionWords(plan) && info.width == source.width &&
               info.height == source.height;
    } catch (const textures::InputError&) {
        return false;  // something else, or damaged: it is replaced
    }
}

ShapeMap bake(const ShapeArguments& arguments, const ShapePlan& plan, const ShapeSource& source) {
    const Stage stage("shape");
    const std::size_t texels =
        static_cast<std::size_t>(source.width) * static_cast<std::size_t>(source.height);
    ShapeMap map;
    try {
        commands::Progress progress("shape", texels);
        map = bakeShape(source, plan, [&](std::size_t count) { progress.advance(count); });
    } catch (const textures::InputError& error) {
        throw textures::InputError(fmt::format("{}: {}", arguments.source, error.what()));
    }
    const auto& shape = map.shape.texels;
    const auto inside = std::ranges::count_if(shape, [](float share) { return share >= 0.5f; });
    stage.done(fmt::format("{} texels, {} inside, slack {:.3g} texels", texels, inside,
                           map.slack * source.width));
    if (inside == 0 || static_cast<std::size_t>(inside) == texels)
        commands::note(fmt::format("{}: {}", arguments.source,
                                   inside == 0 ? "no texel's centre is inside: the shape is empty, "
                                                 "or --inside says the wrong colour"
                                               : "all texels are inside: the shape is full, or "
                                                 "--inside says the wrong colour"));
    return map;
}

void writeOutput(const ShapeArguments& arguments, const ShapePlan& plan, const MapSet& maps) {
    const Stage stage("write");
    textures::writeMapFile(arguments.output, maps, plan.format);
    stage.done(fmt::format("{}, {} channels {}, {} bytes", arguments.output, maps.channels.size(),
                           textures::storageFormatName(plan.format),
                           std::filesystem::file_size(arguments.output)));
}

}  // namespace

CLI::App* addShapeCommand(CLI::App& app, ShapeArguments& arguments) {
    CLI::App* command =
        app.add_subcommand("shape", "Bake the shape map of an image, a drawing or a text");
    const auto add = [&](const char* name, std::string& word, const std::string& description) {
        return command->add_option(name, word, description);
    };
    add("SOURCE", arguments.source,
        "Image (its values are coverage), SVG drawing, or FONT:TEXT with a font file")
        ->required();
    add("-o,--output", arguments.output, "Map file to write: .exr, .png, .tif")->required();
    add("--inside", arguments.inside,
        "What the shape is: black, or white; drawings and text fill with black")
        ->check(CLI::IsMember({"black", "white"}))
        ->capture_default_str();
    add("--wrap", arguments.wrap, "How the shape continues outside its tile")
        ->check(CLI::IsMember({"repeat", "mirror", "clamp"}))
        ->capture_default_str();
    add("--gradient", arguments.gradient,
        "Exact directions from the outline, or Prewitt's kernel of this size")
        ->check(CLI::IsMember({"exact", "3", "5", "7", "9"}))
        ->capture_default_str();
    command->add_flag("--signed", arguments.isSigned,
                      "Distances of both signs, 0 on the outline, below 0 inside [this]");
    command->add_flag("--unsigned", arguments.isUnsigned,
                      "Distances to the nearest texel inside and 0 there, as in the thesis");
    add("--corners", arguments.corners,
        "sharp: two more channels keep corners that bilinear distances round off; round: none "
        "[sharp in .exr, when signed]")
        ->check(CLI::IsMember({"sharp", "round"}));
    add("--channel", arguments.channel, "Channel of an image, by number or name [Y, R, luminance]");
    add("--format", arguments.format, "float, half (.exr), u16, u8 (.png, .tif) [float, u16]")
        ->check(CLI::IsMember({"float", "half", "u16", "u8"}));
    add("--size", arguments.size,
        "Texels of a drawing or a text, WxH, with H/W as in the drawing [512 wide]");
    command->add_flag(
        "--force", arguments.force,
        "Bake even if the output is up to date: the same source, options and version");
    command
        ->add_option("--threads", arguments.threads, "Threads [all cores]; the bytes are the same")
        ->check(CLI::Range(1, kMostThreads));
    command->footer(
        "Examples:\n"
        "  relievo-bake shape star.svg -o star.exr --size 1024x1024\n"
        "  relievo-bake shape /usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf:Relievo -o name.png "
        "--wrap clamp\n"
        "  relievo-bake shape mask.png -o mask.png.exr --inside white --unsigned --gradient 9");
    return command;
}

void runShapeCommand(const ShapeArguments& arguments) {
    const ShapePlan plan = planOf(arguments);
    // Finds out that the folder cannot be written before the work, not after it.
    textures::AtomicFile{arguments.output};
    const auto threads = limitThreads(arguments.threads);
    if (!isDrawing(arguments.source)) {
        const textures::ImageReader header(arguments.source);
        requireRoom(arguments, plan, header.info().width, header.info().height, 0.0);
    }
    const ShapeSource source = readSource(arguments, plan);
    if (!arguments.force && isUpToDate(arguments, plan, source)) {
        commands::say(fmt::format(
            "{} is up to date: the same source, options and version (--force bakes it again)",
            arguments.output));
        return;
    }
    const ShapeMap map = bake(arguments, plan, source);
    writeOutput(arguments, plan, shapeFileOf(map, plan, source.hash));
}

}  // namespace relievo::preprocess
