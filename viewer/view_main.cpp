// relievo-view: shows a relief with one or several techniques, next to the exact picture, in a
// window or without one.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "commands/program.h"
#include "materials/relief_maps.h"
#include "materials/shadow_registry.h"
#include "materials/solid_registry.h"
#include "materials/technique_registry.h"
#include "viewer/headless.h"
#include "viewer/solid_headless.h"
#include "viewer/solid_window.h"
#include "viewer/view_options.h"
#include "viewer/view_window.h"

namespace {

using namespace relievo;

void listParameters(std::span<const materials::TechniqueParameter> parameters) {
    for (const materials::TechniqueParameter& parameter : parameters)
        commands::answer(fmt::format("    {}: {}, {:g} to {:g}, default {:g}", parameter.name,
                                     parameter.description, parameter.minimum, parameter.maximum,
                                     parameter.defaultValue));
}

void listShadowMethod(const materials::ShadowMethod& method) {
    commands::answer(fmt::format("--shadow {}: {} ({})", method.name, method.title, method.origin));
    if (!method.searches)
        commands::answer(fmt::format("    needs --maps {}",
                                     fmt::join(materials::bakeWordsFor(method.maps).maps, ",")));
    listParameters(method.parameters);
}

void listTechniques() {
    for (const materials::Technique& technique : materials::techniques()) {
        commands::answer(
            fmt::format("{}: {} ({})", technique.name, technique.title, technique.origin));
        const materials::BakeWords words = materials::bakeWordsFor(technique.maps);
        commands::answer(fmt::format("    needs --maps {}{}", fmt::join(words.maps, ","),
                                     words.cones.empty() ? "" : " --cone " + words.cones));
        commands::answer(fmt::format(
            "    wrong first hits on the worst sample: at most {:g} % from 45°, {:g} % from 15°",
            technique.errors.at45.wrongPercent, technique.errors.at15.wrongPercent));
        listParameters(technique.parameters);
    }
    for (const materials::ShadowMethod& method : materials::shadowMethods())
        listShadowMethod(method);
    for (const materials::SolidTechnique& entry : materials::solidTechniques()) {
        commands::answer(fmt::format("{}: {} ({}), of shapes and scenes", entry.technique.name,
                                     entry.technique.title, entry.technique.origin));
        listParameters(entry.technique.parameters);
    }
    commands::answer(
        fmt::format("{}: the exact first hits, traced on the CPU", viewer::kReferenceName));
}

// A window wants more room than a picture on a sheet.
constexpr int kWindowPictureSize = 768;

void openWindow(const viewer::ViewOptions& options) {
    if (options.techniques.size() > 2)
        commands::note(
            "a window compares two techniques: the others of --compare are in its lists");
    viewer::runWindow(options);
}

void showSolid(viewer::ViewOptions& options) {
    if (options.techniques.empty())
        options.techniques = {"solid"};
    viewer::checkOutputOptions(options);
    if (options.headless)
        viewer::runSolidHeadless(options);
    else
        viewer::runSolidWindow(options);
}

void run(viewer::ViewOptions& options, bool hasSize) {
    if (!options.headless && !hasSize)
        options.width = options.height = kWindowPictureSize;
    if (!options.list && !options.files.empty() &&
        viewer::isSolidFile(options.files.front().string())) {
        showSolid(options);
        return;
    }
    if (options.techniques.empty())
        options.techniques = {"exact"};
    viewer::checkViewOptions(options);
    if (options.list)
        listTechniques();
    else if (options.headless)
        viewer::runHeadless(options);
    else
        openWindow(options);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Shows reliefs with any technique, next to the exact picture.", "relievo-view");
    viewer::ViewOptions options;
    viewer::addViewOptions(app, options);
    app.footer(
        "Examples:\n"
        "  relievo-view bricks.exr\n"
        "  relievo-view bricks.exr --compare relief,exact,reference --headless -o sheet.png "
        "--error errors.exr\n"
        "  relievo-view bricks.exr --mesh box --tiles 2,2 --depth-scale 0.05 --camera 20,15,2\n"
        "  relievo-view star.svg --mesh shape-box --bevel 0.05 --chamfer 0.3 --curve round\n"
        "  relievo-view scenes/temple.json");
    return commands::runProgram(app, argc, argv, [&] { run(options, app.count("--size") > 0); });
}
