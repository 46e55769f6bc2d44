#include "bench/scene_command.h"

#include "bench/benchmark_options.h"
#include "bench/scenes.h"
#include "commands/program.h"
#include "gl/context.h"
#include "textures/version.h"
#include "viewer/picture.h"

namespace relievo::bench {

SceneCommand::SceneCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "scene", "Lookups and errors of a frame of several objects, against relief mapping")) {
    command_->add_option("--scene", options_.scene, "The scene: hidden or intersections")
        ->type_name("NAME")
        ->capture_default_str()
        ->check(CLI::IsMember(std::vector<std::string>(sceneNames().begin(), sceneNames().end()))
                    .description(""));
    std::vector<std::string> names;
    for (const materials::Technique& technique : materials::techniques())
        names.emplace_back(technique.name);
    command_->add_option("--techniques", options_.techniques, "Search techniques")
        ->delimiter(',')
        ->type_name("NAME,...")
        ->default_str("auto,exact")
        ->check(CLI::IsMember(names).description(""));
    command_
        ->add_option("--pixel-errors", options_.pixelErrors,
                     "Targets of auto: pixels by which a point may be out of place")
        ->delimiter(',')
        ->type_name("PIXELS,...")
        ->default_str("0.25,0.1")
        ->check(CLI::Range(0.001, 64.0));
    const auto add = [this](const char* name, auto& value, const char* description) {
        return command_->add_option(name, value, description)->capture_default_str();
    };
    add("--size", options_.size, "Texels of the reliefs on a side")->check(CLI::Range(1, 8192));
    add("--frame", options_.frame, "Pixels of the frame's height")->check(CLI::Range(3, 4096));
    command_->add_option("--picture", picture_, "Draw the scene by the first technique")
        ->type_name("FILE");
    addReportOptions(*command_, paths_);
    command_->footer(
        "Examples:\n"
        "  relievo-bench scene --markdown scene.md\n"
        "  relievo-bench scene --scene intersections --frame 480 --picture intersections.png");
}

void SceneCommand::run() const {
    ReportFiles files(paths_);
    if (!picture_.empty())
        viewer::requirePictureFile(picture_);
    const auto context = gl::createContext(gl::Backend::OSMesa);
    if (!picture_.empty())
        writeScenePicture(options_, picture_);
    const std::vector<SceneMeasurement> measurements = measureScene(options_);
    const ReportTable table = sceneTable(measurements);
    commands::answer(formatTable(table));
    files.write({.json = {{"benchmark", "scene"},
                          {"version", textures::kVersion},
                          {"scene", options_.scene},
                          {"size", options_.size},
                          {"frame", options_.frame},
                          {"rows", rowsAsJson(table)}},
                 .plot = scenePlot(measurements),
                 .title = "relievo-bench scene",
                 .sections = {{options_.scene, "", table}}});
}

}  // namespace relievo::bench
