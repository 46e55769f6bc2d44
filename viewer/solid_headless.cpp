#include "viewer/solid_headless.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "commands/program.h"
#include "gl/context.h"
#include "materials/solid_registry.h"
#include "textures/file_extension.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "viewer/contact_sheet.h"
#include "viewer/solid_session.h"
#include "viewer/temporal_error.h"
#include "viewer/tessellation_count.h"

namespace relievo::viewer {
namespace {

using commands::UsageError;

void checkOptions(const ViewOptions& options) {
    if (options.files.size() > 1)
        throw UsageError("several files: expected a single scene or shape");
    if (!options.errorFile.empty())
        throw UsageError(
            "--error: scenes and shapes have no exact picture here, see relievo-bench "
            "solid");
    for (const std::string& name : options.techniques)
        static_cast<void>(materials::findSolidTechnique(name));
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

SheetCell renderOne(ViewOptions options, const std::string& name) {
    const materials::SolidTechnique& technique = materials::findSolidTechnique(name);
    SolidSession session(options, technique);
    if (session.scene()) {
        takeSceneView(*session.scene(), options);
        reportScene(*session.scene());
    }
    session.edit(options);
    const Picture picture = render(session, options);
    std::string counts;
    if (session.shape()) {
        const WorkCounts work = countWork(session.measure(options, options.width, options.height));
        counts =
            fmt::format("{:.1f} steps, {:.1f} fetches a pixel", work.meanSteps, work.meanFetches);
        if (work.exhausted > 0)
            counts += fmt::format(", {} ran out", work.exhausted);
        commands::say(fmt::format("  {}: {}", technique.technique.title, counts));
    }
    return {picture, std::string(technique.technique.title), counts};
}

}  // namespace

bool isSolidFile(const std::string& file) {
    if (isSceneFile(file) || textures::lowerExtension(file) == ".svg")
        return true;
    if (!std::filesystem::exists(file))
        return file.find(':') != std::string::npos;  // FONT:TEXT
    return textures::isMapFile(file) && textures::readMapDescription(file).kind == "shape";
}

void runSolidHeadless(const ViewOptions& options) {
    checkOptions(options);
    requirePictureFile(options.output);
    const auto context = gl::createContext(options.backend);
    commands::say(context->description());
    commands::say(options.files.front().string());
    std::vector<SheetCell> cells;
    for (const std::string& name : options.techniques)
        cells.push_back(renderOne(options, name));
    writePicture(options.output,
                 cells.size() == 1 ? cells.front().picture : makeContactSheet({cells}, {}));
    commands::say(fmt::format("wrote {}", options.output.string()));
}

}  // namespace relievo::viewer
