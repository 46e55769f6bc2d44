#include "bench/render_command.h"

#include <utility>

#include "bench/benchmark_options.h"
#include "bench/render_summary.h"
#include "commands/program.h"
#include "materials/technique_registry.h"
#include "textures/version.h"
#include "viewer/view_options.h"

namespace relievo::bench {

RenderCommand::RenderCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "render", "Time, work and error of every search technique and step budget")) {
    for (const materials::Technique& technique : materials::techniques())
        options_.techniques.emplace_back(technique.name);
    addSamplesOption(*command_, options_.samples);
    addNamesOption(*command_, "--techniques", options_.techniques, "Search techniques");
    const auto add = [this](const char* name, auto& value, const char* description) {
        return command_->add_option(name, value, description)->capture_default_str();
    };
    add("--elevations", options_.elevations, "Degrees of the rays above the surface")
        ->delimiter(',')
        ->check(CLI::Range(0.001, 90.0));
    add("--steps", options_.steps, "Step budgets, as far as a technique's goes")
        ->delimiter(',')
        ->check(CLI::Range(1, 65536));
    add("--size", options_.size, "Texels of the reliefs on a side")->check(CLI::Range(1, 8192));
    add("--frame", options_.frame, "Pixels of the frames on a side")->check(CLI::Range(1, 8192));
    add("--depth-scale", options_.depthScale, "Depth of the reliefs in tile widths")
        ->check(CLI::Range(1e-6, 1e3));
    add("--azimuth", options_.azimuth, "Degrees of the rays around the surface's normal")
        ->check(CLI::Range(-360.0, 360.0));
    viewer::addNormalsOption(*command_, options_.normals, "derivative");
    addRepeatOption(*command_, options_.repeat);
    addBackendOption(*command_, options_.backend);
    addPlotAgainstOption(*command_, plotAgainst_);
    addReportOptions(*command_, paths_);
    command_->footer(
        "Examples:\n"
        "  relievo-bench render --samples noise --techniques relief,cone --elevations 45,15\n"
        "  relievo-bench render --steps 16,64,256 --json render.json --plot render.svg\n"
        "  relievo-bench render --techniques relief,exact --steps 32,4096 --markdown render.md");
}

void RenderCommand::run() const {
    ReportFiles files(paths_);
    const RenderReport report = measureRender(options_);
    const ReportTable table = renderTable(report.measurements);
    commands::answer(formatTable(table));
    std::vector<ReportSection> sections = summariseRender(report.measurements);
    sections.push_back({"Every relief", "On " + report.renderer + ".", table});
    files.write(
        {.json = {{"benchmark", "render"},
                  {"version", textures::kVersion},
                  {"renderer", report.renderer},
                  {"size", options_.size},
                  {"frame", options_.frame},
                  {"depthScale", options_.depthScale},
                  {"azimuth", options_.azimuth},
                  {"normals", materials::slopeSourceEntry(
                                  options_.normals.value_or(materials::SlopeSource::Derivative))
                                  .name},
                  {"repeat", options_.repeat},
                  {"rows", rowsAsJson(table)}},
         .plot = renderPlot(report.measurements, plotAgainst_),
         .title = "relievo-bench render",
         .sections = std::move(sections)});
}

}  // namespace relievo::bench
