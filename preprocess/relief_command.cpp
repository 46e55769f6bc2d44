#include "preprocess/relief_command.h"

#include <fmt/core.h>
#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <set>
#include <sstream>
#include <utility>

#include "commands/program.h"
#include "commands/progress.h"
#include "preprocess/cone_encoding.h"
#include "preprocess/cones_by_levels.h"
#include "preprocess/conservative_cones.h"
#include "preprocess/derivatives.h"
#include "preprocess/normals.h"
#include "textures/atomic_file.h"
#include "textures/file_extension.h"
#include "textures/height_image.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "textures/packed_codes.h"
#include "textures/version.h"

namespace relievo::preprocess {
namespace {

using commands::UsageError;
using textures::ConeEncoding;
using textures::MapSet;
using textures::Plane;
using textures::StorageFormat;

constexpr int kMostThreads = 1024;
constexpr double kLargestScale = 1e6;
constexpr std::size_t kPackedChannels = 4;

// What to do, checked: the arguments in the types of the builders.
struct ReliefPlan {
    std::set<std::string> maps;
    textures::HeightImageOptions input;
    ConeEncoding encoding = ConeEncoding::Radius;
    StorageFormat format = StorageFormat::Float;
    [[nodiscard]] bool has(const char* map) const { return maps.count(map) > 0; }
};

std::set<std::string> splitMaps(const std::string& list) {
    static const std::set<std::string> kKnown = {"depth", "derivative", "normal", "cone"};
    std::set<std::string> maps;
    std::istringstream stream(list);
    for (std::string map; std::getline(stream, map, ',');)
        if (kKnown.count(map) == 0)
            throw UsageError(fmt::format(
                "--maps: '{}' is no map, expected some of depth, derivative, normal, cone", map));
        else
            maps.insert(map);
    if (maps.empty())
        throw UsageError("--maps: expected some of depth, derivative, normal, cone");
    return maps;
}

// Words that the design reserves and this version does not bake.
void refuseUnavailable(const ReliefArguments& arguments) {
    const auto refuse = [](const char* option, const std::string& word, const char* available) {
        throw UsageError(fmt::format("{} {}: not available in this version, expected {}", option,
                                     word, available));
    };
    if (arguments.cone != "conservative")
        refuse("--cone", arguments.cone, "conservative");
    if (arguments.guarantee != "texel")
        refuse("--guarantee", arguments.guarantee, "texel");
    if (arguments.method != "exact" && arguments.method != "levels")
        refuse("--method", arguments.method, "exact or levels");
}

StorageFormat formatFor(const ReliefArguments& arguments) {
    const std::filesystem::path file = arguments.output;
    const bool isExr = textures::lowerExtension(file) == ".exr";
    // Half would keep 11 bits of the depths of a 16-bit height image.
    const StorageFormat format = arguments.format.empty()
                                     ? (isExr ? StorageFormat::Float : StorageFormat::U16)
                                     : *textures::storageFormatFromName(arguments.format);
    try {
        textures::requireExtensionFor(file, format);
    } catch (const textures::InputError& error) {
        throw UsageError(error.what());
    }
    return format;
}

void requireRoomForChannels(const ReliefPlan& plan) {
    const std::size_t channels = (plan.has("depth") ? 1u : 0u) +
                                 (plan.has("derivative") ? 2u : 0u) +
                                 (plan.has("normal") ? 3u : 0u) + (plan.has("cone") ? 1u : 0u);
    if (textures::isPackedFormat(plan.format) && channels > kPackedChannels)
        throw UsageError(fmt::format(
            "--maps asks for {} channels, but a PNG or TIFF holds {}: bake to .exr, or fewer maps",
            channels, kPackedChannels));
}

ReliefPlan planOf(const ReliefArguments& arguments) {
    refuseUnavailable(arguments);
    ReliefPlan plan;
    plan.maps = splitMaps(arguments.maps);
    plan.format = formatFor(arguments);
    plan.encoding = *textures::coneEncodingFromName(arguments.encoding);
    plan.input.isDepth = arguments.input == "depth";
    plan.input.channel = arguments.channel;
    plan.input.wrap = *textures::wrapModeFromName(arguments.wrap);
    plan.input.notice = commands::note;
    requireRoomForChannels(plan);
    // A radius alone says nothing: the search divides it by the depth.
    if (plan.has("cone") && plan.encoding == ConeEncoding::Radius && !plan.has("depth"))
        throw UsageError("--maps: cones as radii need the map depth beside them");
    if (std::isnan(arguments.normalScale))  // passes every check of a range
        throw UsageError("--normal-scale: expected a number");
    std::error_code missing;
    if (std::filesystem::equivalent(arguments.height, arguments.output, missing))
        throw UsageError(fmt::format("-o {}: is the height image itself", arguments.output));
    return plan;
}

// Times a stage and says what it did when it is over.
class Stage {
  public:
    explicit Stage(std::string name)
        : name_(std::move(name)), start_(std::chrono::steady_clock::now()) {}
    void done(const std::string& counts) const {
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start_;
        commands::say(fmt::format("{:<10} {:<62} {:7.2f} s", name_, counts, time.count()));
    }

  private:
    std::string name_;
    std::chrono::steady_clock::time_point start_;
};

void addDerivatives(const ReliefPlan& plan, const ReliefArguments& arguments,
                    const textures::DepthMap& relief, MapSet& maps) {
    const Stage stage("slopes");
    Derivatives derivatives = buildDerivatives(relief);
    std::string names;
    if (plan.has("normal")) {
        Normals normals = buildNormals(derivatives, arguments.normalScale);
        maps.channels.push_back({"nx", std::move(normals.nx)});
        maps.channels.push_back({"ny", std::move(normals.ny)});
        maps.channels.push_back({"nz", std::move(normals.nz)});
        maps.attributes["relievo:normal-scale"] = fmt::format("{}", arguments.normalScale);
        names = fmt::format("nx, ny, nz at depth scale {}  ", arguments.normalScale);
    }
    if (plan.has("derivative")) {
        maps.channels.push_back({"dx", std::move(derivatives.dx)});
        maps.channels.push_back({"dy", std::move(derivatives.dy)});
        names += "dx, dy";
    }
    stage.done(names);
}

Plane coneRatios(const textures::DepthMap& relief, const std::string& method, std::string& counts) {
    const std::size_t texels = relief.depth.texels.size();
    commands::Progress progress("cones", texels);
    const auto advance = [&](std::size_t done) { progress.advance(done); };
    if (method == "levels")
        return buildConesByLevels(relief, 256, advance);
    ConeSearchStatistics work;
    Plane ratio = buildConservativeCones(relief, advance, &work);
    counts = fmt::format(", {:.1f} nodes and {:.1f} texels visited for each",
                         static_cast<double>(work.nodes) / static_cast<double>(texels),
                         static_cast<double>(work.texels) / static_cast<double>(texels));
    return ratio;
}

void warnOfPackedCones(const Plane& cone, StorageFormat format) {
    if (const std::size_t zero = textures::countVanishing(cone, "cone", format); zero > 0)
        commands::note(fmt::format(
            "{} cones are too narrow for {} and are stored as 0, where a search stalls: bake to "
            "u16 or .exr",
            zero, textures::storageFormatName(format)));
    if (!textures::isPackedFormat(format))
        return;
    const double top = textures::packedRange(cone, "cone", format).high;
    const auto wider = std::count_if(cone.texels.begin(), cone.texels.end(), [&](float value) {
        return std::isfinite(value) && value > top;
    });
    if (wider > 0)
        commands::note(
            fmt::format("{} cones are wider than {}, the most that a packed file holds, "
                        "and are narrowed: safe, with more steps",
                        wider, top));
}

void addCones(const ReliefPlan& plan, const ReliefArguments& arguments,
              const textures::DepthMap& relief, MapSet& maps) {
    const Stage stage("cones");
    std::string counts;
    const Plane ratio = coneRatios(relief, arguments.method, counts);
    maps.encoding = plan.encoding;
    maps.attributes["relievo:cone"] = arguments.cone;
    maps.attributes["relievo:guarantee"] = arguments.guarantee;
    maps.attributes["relievo:method"] = arguments.method;
    maps.channels.push_back({"cone", encodeCones(ratio, relief.depth, plan.encoding)});
    stage.done(fmt::format("{} texels{}", ratio.texels.size(), counts));
    warnOfPackedCones(maps.channels.back().plane, plan.format);
}

textures::HeightImage readInput(const ReliefPlan& plan, const ReliefArguments& arguments) {
    const Stage stage("read");
    textures::HeightImage image = textures::readHeightImage(arguments.height, plan.input);
    const Plane& depth = image.depth.depth;
    stage.done(
        fmt::format("{}, {}×{}, {}", arguments.height, depth.width, depth.height, arguments.wrap));
    return image;
}

void writeOutput(const ReliefPlan& plan, const ReliefArguments& arguments, const MapSet& maps) {
    const Stage stage("write");
    textures::writeMapFile(arguments.output, maps, plan.format);
    stage.done(fmt::format("{}, {} channels {}, {} bytes", arguments.output, maps.channels.size(),
                           textures::storageFormatName(plan.format),
                           std::filesystem::file_size(arguments.output)));
}

}  // namespace

CLI::App* addReliefCommand(CLI::App& app, ReliefArguments& arguments) {
    CLI::App* command = app.add_subcommand("relief", "Bake the maps of a height image");
    const auto add = [&](const char* name, std::string& word, const char* description) {
        return command->add_option(name, word, description);
    };
    add("HEIGHT", arguments.height, "Height image, of any format that OpenImageIO reads")
        ->required();
    add("-o,--output", arguments.output, "Map file to write: .exr, .png, .tif")->required();
    add("--maps", arguments.maps, "Some of depth,derivative,normal,cone, with commas")
        ->capture_default_str();
    add("--cone", arguments.cone, "Kind of cones; relaxed and roof are for later versions")
        ->check(CLI::IsMember({"conservative", "relaxed", "roof"}))
        ->capture_default_str();
    add("--guarantee", arguments.guarantee,
        "What the cones are safe for: texel centres; bilinear is for later versions")
        ->check(CLI::IsMember({"bilinear", "texel"}))
        ->capture_default_str();
    add("--method", arguments.method,
        "Builder of the cones: exact, or the baseline levels (exact up to 256 distinct depths, "
        "narrower above)")
        ->check(CLI::IsMember({"exact", "levels", "squares", "maxima", "policarpo"}))
        ->capture_default_str();
    add("--wrap", arguments.wrap, "How the relief continues outside its tile")
        ->check(CLI::IsMember({"repeat", "mirror", "clamp"}))
        ->capture_default_str();
    add("--input", arguments.input, "What white means: high, or deep")
        ->check(CLI::IsMember({"height", "depth"}))
        ->capture_default_str();
    add("--channel", arguments.channel,
        "Channel of the image, by number or name [Y, R, luminance]");
    add("--encode", arguments.encoding, "Cones as ratios or as radii at the reference surface")
        ->check(CLI::IsMember({"ratio", "radius"}))
        ->capture_default_str();
    add("--format", arguments.format, "float, half (.exr), u16, u8 (.png, .tif) [float, u16]")
        ->check(CLI::IsMember({"float", "half", "u16", "u8"}));
    command
        ->add_option("--normal-scale", arguments.normalScale,
                     "Depth scale of the map normal, in tile widths")
        ->check(CLI::Range(0.0, kLargestScale))
        ->capture_default_str();
    command
        ->add_option("--threads", arguments.threads, "Threads [all cores]; the bytes are the same")
        ->check(CLI::Range(1, kMostThreads));
    command->footer(
        "Memory: up to 150 bytes a texel, 2.5 GB for 4096×4096.\n"
        "Examples:\n"
        "  relievo-bake relief bricks.png -o bricks.exr\n"
        "  relievo-bake relief rock.tif -o rock.png --wrap mirror --format u8\n"
        "  relievo-bake relief scan.exr -o maps.exr --input depth --channel Z --maps "
        "depth,normal");
    return command;
}

void runReliefCommand(const ReliefArguments& arguments) {
    const ReliefPlan plan = planOf(arguments);
    // Finds out that the folder cannot be written before the work, not after it.
    textures::AtomicFile{arguments.output};
    const tbb::global_control threads(
        tbb::global_control::max_allowed_parallelism,
        arguments.threads > 0
            ? static_cast<std::size_t>(arguments.threads)
            : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));

    textures::HeightImage image = readInput(plan, arguments);
    MapSet maps;
    maps.wrap = plan.input.wrap;
    maps.source = image.source;
    maps.version = textures::kVersion;
    // All maps belong to the depths that the file will hold, not to those before rounding.
    textures::DepthMap& relief = image.depth;
    relief.depth = textures::storedValues(relief.depth, "depth", plan.format);
    if (plan.has("derivative") || plan.has("normal"))
        addDerivatives(plan, arguments, relief, maps);
    if (plan.has("cone"))
        addCones(plan, arguments, relief, maps);
    if (plan.has("depth"))
        maps.channels.push_back({"depth", std::move(relief.depth)});
    writeOutput(plan, arguments, maps);
}

}  // namespace relievo::preprocess
