#include "preprocess/relief_command.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "commands/program.h"
#include "commands/progress.h"
#include "preprocess/command_options.h"
#include "preprocess/cone_kinds.h"
#include "preprocess/map_kinds.h"
#include "preprocess/memory_need.h"
#include "preprocess/relief_baker.h"
#include "textures/atomic_file.h"
#include "textures/channel_rules.h"
#include "textures/file_extension.h"
#include "textures/height_image.h"
#include "textures/image_reader.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "textures/version.h"

namespace relievo::preprocess {
namespace {

using commands::UsageError;
using textures::MapSet;
using textures::Plane;

constexpr double kLeastScale = 1e-6;
constexpr double kLargestScale = 1e6;

// What to do, checked: the arguments in the types of the library.
struct Job {
    ReliefPlan plan;
    textures::HeightImageOptions input;
};

std::vector<std::string> splitMaps(const std::string& list) {
    std::vector<std::string> maps;
    std::istringstream stream(list);
    for (std::string map; std::getline(stream, map, ',');)
        if (std::find(maps.begin(), maps.end(), map) == maps.end())
            maps.push_back(map);
    return maps;
}

Job jobOf(const ReliefArguments& arguments) {
    Job job;
    job.plan.maps = splitMaps(arguments.maps);
    job.plan.guarantee = arguments.guarantee;
    job.plan.method = arguments.method;
    job.plan.sectors = arguments.sectors;
    job.plan.encoding = textures::coneEncodingFromName(arguments.encoding);
    job.plan.format = outputFormat(arguments.output, arguments.format);
    job.plan.cone = arguments.cone.empty() ? usualCone(job.plan) : arguments.cone;
    job.plan.mips = arguments.mips;
    job.plan.normalScale = arguments.normalScale;
    job.plan.reach = arguments.reach;
    job.plan.cylinderTolerance = arguments.cylinderTolerance;
    job.plan.azimuths = arguments.azimuths;
    job.plan.slices = arguments.slices;
    job.plan.volumeScale = arguments.volumeScale;
    job.plan.views = arguments.views;
    job.plan.terms = arguments.terms;
    job.input.isDepth = arguments.input == "depth";
    job.input.channel = arguments.channel;
    job.input.wrap = *textures::wrapModeFromName(arguments.wrap);
    job.input.notice = commands::note;
    if (const std::string problem = planProblem(job.plan); !problem.empty())
        throw UsageError(problem);
    if (job.plan.mips && textures::lowerExtension(arguments.output) == ".png")
        throw UsageError("--mips: a .png file holds no MIP levels, expected .exr or .tif");
    std::error_code missing;
    if (std::filesystem::equivalent(arguments.height, arguments.output, missing))
        throw UsageError(fmt::format("-o {}: is the height image itself", arguments.output));
    return job;
}

// Bakes with a progress bar and a line for each map.
std::vector<MapSet> bake(textures::DepthMap relief, const ReliefPlan& plan) {
    std::optional<Stage> stage;
    std::optional<commands::Progress> progress;
    std::size_t size = 0;
    BakeObserver observer;
    observer.begin = [&](std::string_view map, std::size_t texels) {
        size = texels;
        stage.emplace(std::string(map));
        progress.emplace(std::string(map), texels);
    };
    observer.advance = [&](std::size_t texels) { progress->advance(texels); };
    observer.end = [&](std::string_view, const std::string& counts) {
        progress.reset();
        stage->done(fmt::format("{} texels, {}", size, counts));
    };
    return bakeLevels(std::move(relief), plan, observer);
}

// What storing the widths of cones costs; they are never wider than true.
void reportLoss(const textures::Channel& channel, const ReliefPlan& plan,
                textures::ConeEncoding encoding) {
    const textures::StorageLoss loss =
        textures::storageLoss(channel.plane, channel.name, plan.format, encoding);
    commands::say(
        fmt::format("{:<10} {} as {} in {}: {:.4f} of the true width in the mean, {:.4f} at worst",
                    "stored", channel.name, textures::coneEncodingName(encoding),
                    textures::storageFormatName(plan.format), loss.meanShare, loss.worstShare));
    if (loss.vanishing > 0)
        commands::note(fmt::format(
            "{} cones are too narrow for {} and are stored as 0, where a search stalls: --encode "
            "sqrt, u16 or .exr may hold them",
            loss.vanishing, textures::storageFormatName(plan.format)));
    if (loss.narrowed > 0)
        commands::note(fmt::format(
            "{} cones are wider than {}, the most that the file holds, and are narrowed: safe, "
            "with more steps",
            loss.narrowed, loss.widest));
}

void reportLosses(const MapSet& maps, const ReliefPlan& plan) {
    for (const textures::Channel& channel : maps.channels)
        if (textures::channelRule(channel.name).isCone)
            reportLoss(channel, plan, maps.encoding);
}

// Whether the output is there, whole, and made of the same depths by the same options and version.
bool isUpToDate(const Job& job, const ReliefArguments& arguments, const std::string& source) {
    if (!std::filesystem::exists(arguments.output))
        return false;
    try {
        const MapSet old = textures::readMapDescription(arguments.output);
        const auto options = old.attributes.find("relievo:options");
        return old.source == source && old.wrap == job.input.wrap &&
               old.version == textures::kVersion && options != old.attributes.end() &&
               options->second == optionWords(job.plan);
    } catch (const textures::InputError&) {
        return false;  // something else, or damaged: it is replaced
    }
}

// The libraries and the system would end a program that takes more than there is, at any time.
void requireRoom(const Job& job, const ReliefArguments& arguments) {
    const textures::ImageReader header(arguments.height);
    const int width = header.info().width;
    const int height = header.info().height;
    textures::requireReadableSize(arguments.output, width, height, channelCount(job.plan));
    requireMemory(arguments.height, job.plan, width, height, availableMemory());
}

// What the maps will be, before the work.
void reportSizes(const ReliefPlan& plan, const Plane& depth) {
    const std::size_t planeBytes = depth.texels.size() * sizeof(float);
    commands::say(
        fmt::format("{:<10} {} channels, {} bytes as floats; up to {} of memory", "plan",
                    channelCount(plan), channelCount(plan) * planeBytes,
                    memoryText(static_cast<double>(memoryNeed(plan, depth.width, depth.height)))));
    if (!plan.has("vdm"))
        return;
    std::string sizes = fmt::format("{} views, {} bytes as a table", plan.views.views(),
                                    plan.views.views() * planeBytes);
    if (plan.terms > 0)
        sizes += fmt::format(", {} as {} terms",
                             findMapKind("vdm")->channels(plan).size() * planeBytes, plan.terms);
    commands::say(fmt::format("{:<10} {}", "vdm", sizes));
}

textures::HeightImage readInput(const Job& job, const ReliefArguments& arguments) {
    const Stage stage("read");
    textures::HeightImage image = textures::readHeightImage(arguments.height, job.input);
    const Plane& depth = image.depth.depth;
    stage.done(
        fmt::format("{}, {}×{}, {}", arguments.height, depth.width, depth.height, arguments.wrap));
    return image;
}

void writeOutput(const ReliefPlan& plan, const ReliefArguments& arguments,
                 const std::vector<MapSet>& levels) {
    const Stage stage("write");
    textures::writeMapFile(arguments.output, levels, plan.format);
    const std::size_t channels = levels.front().channels.size();
    const std::string count = levels.size() > 1 ? fmt::format("{} levels, ", levels.size()) : "";
    stage.done(fmt::format("{}, {}{} channels {}, {} bytes", arguments.output, count, channels,
                           textures::storageFormatName(plan.format),
                           std::filesystem::file_size(arguments.output)));
}

std::string mapsDescription() {
    std::string description = "Some of these, with commas:";
    for (const MapKind& kind : mapKinds())
        description += fmt::format("\n{} ({})", kind.name, kind.description);
    return description;
}

void addViewOptions(CLI::App& command, ReliefArguments& arguments) {
    const auto add = [&](const char* name, int& number, int least, int most,
                         const char* description) {
        command.add_option(name, number, description)
            ->check(CLI::Range(least, most))
            ->capture_default_str();
    };
    ViewGrid& views = arguments.views;
    add("--vdm-azimuths", views.azimuths, kFewestAzimuths, kMostAzimuths,
        "Azimuths of the views of the map vdm");
    add("--vdm-elevations", views.elevations, 1, kMostElevations, "Elevations of its views");
    add("--vdm-curvatures", views.curvatures, 1, kMostCurvatures,
        "Curvatures of its base surface, an odd number");
    command
        .add_option("--vdm-range", views.sharpest,
                    "Greatest of them, in radians per tile width; the least is opposite")
        ->check(CLI::Range(0.0, kLargestSharpest))
        ->capture_default_str();
    command.add_option("--vdm-scale", views.depthScale, "Its depth scale, in tile widths")
        ->check(CLI::Range(kLeastScale, kLargestViewScale))
        ->capture_default_str();
    add("--vdm-terms", arguments.terms, 0, kMostTerms,
        "Terms into which its table is packed; 0: the whole table");
}

}  // namespace

CLI::App* addReliefCommand(CLI::App& app, ReliefArguments& arguments) {
    CLI::App* command = app.add_subcommand("relief", "Bake the maps of a height image");
    const auto add = [&](const char* name, std::string& word, const std::string& description) {
        return command->add_option(name, word, description);
    };
    add("HEIGHT", arguments.height, "Height image, of any format that OpenImageIO reads")
        ->required();
    add("-o,--output", arguments.output, "Map file to write: .exr, .png, .tif")->required();
    add("--maps", arguments.maps, mapsDescription())->capture_default_str();
    add("--cone", arguments.cone,
        "Kind of cones [roof in .exr, conservative in .png and .tif, which have too few channels]")
        ->check(CLI::IsMember(coneWords(&ConeKind::cone)));
    command
        ->add_option(
            "--sectors", arguments.sectors,
            "Sectors of ray directions with cones of their own: 1, 4 or 8 [roof 4, relaxed "
            "8 in .exr, 1 in .png and .tif, others 1]")
        ->check(CLI::IsMember({1, 4, 8}));
    add("--guarantee", arguments.guarantee,
        "What the cones are safe for: the bilinear surface, texel centres only, or nothing [the "
        "first that kind and method have]")
        ->check(CLI::IsMember(coneWords(&ConeKind::guarantee)));
    add("--method", arguments.method,
        "Builder of the cones: exact, or a baseline: levels, squares, quick (conservative), "
        "maxima, "
        "policarpo (relaxed) [the first that the kind has]")
        ->check(CLI::IsMember(coneWords(&ConeKind::method)));
    add("--wrap", arguments.wrap, "How the relief continues outside its tile")
        ->check(CLI::IsMember({"repeat", "mirror", "clamp"}))
        ->capture_default_str();
    add("--input", arguments.input, "What white means: high, or deep")
        ->check(CLI::IsMember({"height", "depth"}))
        ->capture_default_str();
    add("--channel", arguments.channel,
        "Channel of the image, by number or name [Y, R, luminance]");
    add("--encode", arguments.encoding,
        "Cones as ratios, as radii at the reference surface, or as square roots of ratios, which "
        "serve 8 bits [ratio]")
        ->check(CLI::IsMember({"ratio", "radius", "sqrt"}));
    add("--format", arguments.format, "float, half (.exr), u16, u8 (.png, .tif) [float, u16]")
        ->check(CLI::IsMember({"float", "half", "u16", "u8"}));
    command->add_flag("--mips", arguments.mips,
                      "MIP levels as well, each with maps of its own (.exr, .tif)");
    command->add_flag(
        "--force", arguments.force,
        "Bake even if the output is up to date: the same depths, options and version");
    command
        ->add_option("--normal-scale", arguments.normalScale,
                     "Depth scale of the maps normal, occlusion and ellipse, in tile widths")
        ->check(CLI::Range(0.0, kLargestScale))
        ->capture_default_str();
    command
        ->add_option("--reach", arguments.reach,
                     "How far around a texel the map extrema looks, in texels")
        ->check(CLI::Range(0, kFarthestReach))
        ->capture_default_str();
    command
        ->add_option("--cylinder-tolerance", arguments.cylinderTolerance,
                     "How deep below the surface a ray may be without counting for the map "
                     "cylinder")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    command
        ->add_option("--azimuths", arguments.azimuths,
                     "Directions of the map horizon, of which occlusion and ellipse are made")
        ->check(CLI::Range(kFewestAzimuths, kMostAzimuths))
        ->capture_default_str();
    command->add_option("--slices", arguments.slices, "Layers of the map volume")
        ->check(CLI::Range(1, kMostSlices))
        ->capture_default_str();
    command
        ->add_option("--volume-scale", arguments.volumeScale,
                     "Depth scale of the map volume, in tile widths")
        ->check(CLI::Range(kLeastScale, kLargestScale))
        ->capture_default_str();
    addViewOptions(*command, arguments);
    command
        ->add_option("--threads", arguments.threads, "Threads [all cores]; the bytes are the same")
        ->check(CLI::Range(1, kMostThreads));
    ReliefPlan usual;
    usual.cone = usualCone(usual);
    command->footer(fmt::format(
        "Memory: {:.0f} bytes a texel for the maps above, {} for 4096×4096. A map that would not "
        "fit "
        "is refused before the start.\n"
        "Examples:\n"
        "  relievo-bake relief bricks.png -o bricks.exr\n"
        "  relievo-bake relief rock.tif -o rock.png --wrap mirror --format u8 --encode sqrt\n"
        "  relievo-bake relief scan.exr -o maps.exr --input depth --channel Z --maps depth,normal",
        memoryPerTexel(usual), memoryText(static_cast<double>(memoryNeed(usual, 4096, 4096)))));
    return command;
}

void runReliefCommand(const ReliefArguments& arguments) {
    const Job job = jobOf(arguments);
    // Finds out that the folder cannot be written before the work, not after it.
    textures::AtomicFile{arguments.output};
    const auto threads = limitThreads(arguments.threads);
    requireRoom(job, arguments);
    textures::HeightImage image = readInput(job, arguments);
    if (!arguments.force && isUpToDate(job, arguments, image.source)) {
        commands::say(fmt::format(
            "{} is up to date: the same source, options and version (--force bakes it again)",
            arguments.output));
        return;
    }
    reportSizes(job.plan, image.depth.depth);
    std::vector<MapSet> levels = bake(std::move(image.depth), job.plan);
    for (MapSet& level : levels)
        level.source = image.source;
    reportLosses(levels.front(), job.plan);
    writeOutput(job.plan, arguments, levels);
}

}  // namespace relievo::preprocess
