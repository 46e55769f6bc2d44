#include "viewer/solid_headless.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "commands/program.h"
#include "gl/context.h"
#include "materials/solid_registry.h"
#include "textures/file_extension.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "viewer/contact_sheet.h"
#include "viewer/heat_map.h"
#include "viewer/solid_session.h"
#include "viewer/temporal_error.h"
#include "viewer/tessellation_count.h"

namespace relievo::viewer {
namespace {

using commands::UsageError;

void requireNoReliefOptions(const ViewOptions& options) {
    const auto refuse = [](std::string_view option) {
        throw UsageError(fmt::format("--{} is for reliefs, not for scenes and shapes", option));
    };
    for (const auto& [name, file] : options.textures)
        if (name != "albedo")
            refuse(name);
    if (options.bakedOcclusion)
        refuse("occlusion");
    if (options.normals)
        refuse("normals");
    if (options.level)
        refuse("level");
    if (options.lightSize > 0.0f)
        refuse("light-size");
}

// Every --set must reach one of the techniques.
void checkSetting(const ViewOptions& options, const ParameterSetting& setting) {
    const auto isOf = [&](const std::string& name) {
        const materials::Technique& technique = materials::findSolidTechnique(name).technique;
        return (setting.technique.empty() || setting.technique == name) &&
               std::ranges::any_of(technique.parameters,
                                   [&](const auto& info) { return info.name == setting.name; });
    };
    if (std::ranges::none_of(options.techniques, isOf))
        throw UsageError(
            fmt::format("--set {}: no technique shown has a parameter of that name; see "
                        "relievo-view --list",
                        setting.name));
}

void reportScene(const SceneFile& scene) {
    const SceneTriangles triangles = countTriangles(scene);
    commands::say(fmt::format("  {} boxes: {} triangles, meshes in their stead at least {}",
                              triangles.boxes, triangles.drawn, triangles.tessellated));
}

// As many rays a pixel as options.rays allows, evenly spread along both sides.
Picture render(SolidSession& session, const ViewOptions& options) {
    const int factor = static_cast<int>(std::sqrt(static_cast<double>(options.rays)));
    gl::Framebuffer target(factor * options.width, factor * options.height,
                           std::array<GLenum, 1>{GL_RGBA8});
    session.draw(options, target);
    Picture picture(target.width(), target.height());
    picture.rgba = target.read(0);
    return averaged(picture, factor);
}

// What one search shows of the file.
struct SearchResult {
    SheetCell picture;
    std::optional<SheetCell> heatMap;
    std::vector<NamedPlane> errors;
};

std::string countsOf(const MeasuredFrame& frame) {
    const WorkCounts work = countWork(frame);
    std::string counts =
        fmt::format("{:.1f} steps, {:.1f} fetches a pixel", work.meanSteps, work.meanFetches);
    if (work.exhausted > 0)
        counts += fmt::format(", {} ran out", work.exhausted);
    return counts;
}

void addErrors(const SolidErrors& errors, const materials::Technique& technique,
               SearchResult& result) {
    const reference::ErrorStatistics& statistics = errors.statistics;
    const std::string summary =
        fmt::format("{:.2f} % wrong, mean {:.4f}, max {:.1f} texels", 100 * statistics.wrongShare,
                    statistics.meanDistance, statistics.maximumDistance);
    commands::say(fmt::format("    against the exact hits: {}", summary));
    result.heatMap = {heatMap(errors.image), fmt::format("error of {}", technique.title), summary};
    result.errors = namedPlanes(errors, std::string(technique.name));
}

SearchResult renderOne(ViewOptions options, const std::string& name) {
    const materials::Technique& technique = materials::findSolidTechnique(name).technique;
    SolidSession session(options, materials::findSolidTechnique(name));
    if (session.scene()) {
        takeSceneView(*session.scene(), options);
        reportScene(*session.scene());
    }
    session.edit(options);
    SearchResult result{{render(session, options), std::string(technique.title), ""}, {}, {}};
    if (session.shape()) {
        const MeasuredFrame frame = session.measure(options, options.width, options.height);
        result.picture.subtitle = countsOf(frame);
        commands::say(fmt::format("  {}: {}", technique.title, result.picture.subtitle));
        if (!options.errorFile.empty())
            addErrors(session.errorsOf(frame, options), technique, result);
    }
    return result;
}

// A single picture without errors is no sheet.
Picture assemble(std::vector<SearchResult>& results) {
    std::vector<std::vector<SheetCell>> rows(1);
    std::vector<SheetCell> heatMaps;
    for (SearchResult& result : results) {
        rows.front().push_back(std::move(result.picture));
        if (result.heatMap)
            heatMaps.push_back(std::move(*result.heatMap));
    }
    if (heatMaps.empty())
        return results.size() == 1 ? rows.front().front().picture : makeContactSheet(rows, {});
    const int width = rows.front().front().picture.width;
    const int columns = static_cast<int>(results.size());
    rows.push_back(std::move(heatMaps));
    return makeContactSheet(rows, heatScale(std::max(480, std::min(columns, 2) * width)));
}

}  // namespace

void checkSolidOptions(const ViewOptions& options) {
    if (options.files.size() > 1)
        throw UsageError("several files: expected a single scene or shape");
    if (!options.errorFile.empty() && isSceneFile(options.files.front().string()))
        throw UsageError("--error compares single shapes, not scenes");
    requireNoReliefOptions(options);
    if (!isSceneFile(options.files.front().string()))
        requireNoShadowTexels(options);
    for (const std::string& name : options.techniques)
        static_cast<void>(materials::findSolidTechnique(name));
    for (const ParameterSetting& setting : options.parameters)
        checkSetting(options, setting);
}

bool isSolidFile(const std::string& file) {
    if (isSceneFile(file) || textures::lowerExtension(file) == ".svg")
        return true;
    if (!std::filesystem::exists(file))
        return file.find(':') != std::string::npos;  // FONT:TEXT
    return textures::isMapFile(file) && textures::readMapDescription(file).kind == "shape";
}

void runSolidHeadless(const ViewOptions& options) {
    checkSolidOptions(options);
    requirePictureFile(options.output);
    if (!options.errorFile.empty())
        requireChannelFile(options.errorFile);
    const auto context = gl::createContext(options.backend);
    commands::say(context->description());
    commands::say(options.files.front().string());
    std::vector<SearchResult> results;
    std::vector<NamedPlane> errors;
    for (const std::string& name : options.techniques) {
        results.push_back(renderOne(options, name));
        std::ranges::move(results.back().errors, std::back_inserter(errors));
    }
    if (!options.errorFile.empty()) {
        writeChannels(options.errorFile, errors);
        commands::say(fmt::format("wrote {}", options.errorFile.string()));
    }
    writePicture(options.output, assemble(results));
    commands::say(fmt::format("wrote {}", options.output.string()));
}

}  // namespace relievo::viewer
