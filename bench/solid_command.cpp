#include "bench/solid_command.h"

#include <utility>

#include "bench/benchmark_options.h"
#include "bench/solid_models.h"
#include "bench/solid_summary.h"
#include "commands/program.h"
#include "textures/version.h"

namespace relievo::bench {

SolidCommand::SolidCommand(CLI::App& app)
    : command_(
          app.add_subcommand("solid",
                             "Time, work and faults of searches of extrusions and revolutions, "
                             "and of the same as reliefs")) {
    options_.solids.assign(solidModelNames().begin(), solidModelNames().end());
    options_.shapes.assign(solidShapeNames().begin(), solidShapeNames().end());
    options_.techniques = solidBenchmarkTechniques();
    addNamesOption(*command_, "--solids", options_.solids, "What is made of the shapes");
    addNamesOption(*command_, "--shapes", options_.shapes,
                   "Shapes of extrusions and sections of revolutions");
    addNamesOption(*command_, "--techniques", options_.techniques,
                   "Searches of solids, and of reliefs for extrusions");
    const auto add = [this](const char* name, auto& value, const char* description) {
        return command_->add_option(name, value, description)->capture_default_str();
    };
    add("--elevations", options_.elevations, "Degrees of the rays above the plane")
        ->delimiter(',')
        ->check(CLI::Range(0.001, 90.0));
    add("--steps", options_.steps, "Step budgets besides the default one of each technique")
        ->delimiter(',')
        ->check(CLI::Range(1, 65536));
    add("--sizes", options_.sizes, "Texels of the shape maps on a side")
        ->delimiter(',')
        ->check(CLI::Range(4, 8192));
    add("--frame", options_.frame, "Pixels of the frames on a side")->check(CLI::Range(1, 8192));
    add("--depth-scale", options_.depthScale, "Depth of the extrusions in tile widths")
        ->check(CLI::Range(1e-6, 1e3));
    add("--azimuth", options_.azimuth, "Degrees of the rays around the plane's normal")
        ->check(CLI::Range(-360.0, 360.0));
    add("--corners", options_.corners,
        "sharp: maps with creases, which only the search `solid` reads; round: without")
        ->check(CLI::IsMember({"sharp", "round"}));
    addRepeatOption(*command_, options_.repeat);
    addBackendOption(*command_, options_.backend);
    addPlotAgainstOption(*command_, plotAgainst_);
    addReportOptions(*command_, paths_);
    command_->footer(
        "Examples:\n"
        "  relievo-bench solid --solids chamfer-large --shapes star --elevations 15,1\n"
        "  relievo-bench solid --techniques solid,relief,cone --plot-against fetches --plot "
        "solids.svg\n"
        "  relievo-bench solid --json solids.json --markdown solids.md");
}

void SolidCommand::run() const {
    ReportFiles files(paths_);
    const SolidReport report = measureSolids(options_);
    const ReportTable table = solidTable(report.measurements);
    commands::answer(formatTable(table));
    std::vector<ReportSection> sections = summariseSolids(report.measurements);
    sections.push_back({"Every solid", "On " + report.renderer + ".", table});
    files.write({.json = {{"benchmark", "solid"},
                          {"version", textures::kVersion},
                          {"renderer", report.renderer},
                          {"sizes", options_.sizes},
                          {"frame", options_.frame},
                          {"depthScale", options_.depthScale},
                          {"azimuth", options_.azimuth},
                          {"corners", options_.corners},
                          {"repeat", options_.repeat},
                          {"rows", rowsAsJson(table)}},
                 .plot = solidPlot(report.measurements, plotAgainst_),
                 .title = "relievo-bench solid",
                 .sections = std::move(sections)});
}

}  // namespace relievo::bench
