#include "bench/shadow_command.h"

#include <fmt/format.h>

#include <utility>

#include "bench/benchmark_options.h"
#include "commands/program.h"
#include "materials/shadow_registry.h"
#include "textures/version.h"

namespace relievo::bench {
namespace {

// Techniques that can search light rays.
std::vector<std::string> searchNames() {
    std::vector<std::string> names;
    for (const materials::Technique& technique : materials::techniques())
        if (technique.isSearch)
            names.emplace_back(technique.name);
    return names;
}

}  // namespace

ShadowCommand::ShadowCommand(CLI::App& app)
    : command_(app.add_subcommand("shadow",
                                  "Time, lookups and error of every method of self-shadowing")) {
    addSamplesOption(*command_, options_.samples);
    options_.methods = {kNoShadow};
    for (const materials::ShadowMethod& method : materials::shadowMethods())
        options_.methods.emplace_back(method.name);
    addNamesOption(*command_, "--methods", options_.methods, "Shadow methods");
    const auto add = [this](const char* name, auto& value, const char* description) {
        return command_->add_option(name, value, description)->capture_default_str();
    };
    add("--technique", options_.technique, "Technique that searches, for the view and for light")
        ->check(CLI::IsMember(searchNames()).description(""))
        ->type_name("NAME");
    add("--elevations", options_.elevations, "Degrees of the light above the surface")
        ->delimiter(',')
        ->check(CLI::Range(0.01, 90.0));
    add("--light-sizes", options_.lightSizes, "Degrees that the light spans; 0 is a point")
        ->delimiter(',')
        ->check(CLI::Range(0.0, 60.0));
    add("--budgets", options_.budgets, "Budgets, for methods that have one: slices of the light")
        ->delimiter(',')
        ->check(CLI::Range(1, 65536));
    add("--size", options_.size, "Texels of the reliefs on a side")->check(CLI::Range(1, 8192));
    add("--frame", options_.frame, "Pixels of the frames on a side")->check(CLI::Range(1, 8192));
    add("--light-rays", options_.lightRays, "Exact rays from a point to a light that spans degrees")
        ->check(CLI::Range(1, 65536));
    add("--view-elevation", options_.viewElevation, "Degrees of the view above the surface")
        ->check(CLI::Range(0.1, 90.0));
    add("--depth-scale", options_.depthScale, "Depth of the reliefs in tile widths")
        ->check(CLI::Range(1e-6, 1e3));
    addRepeatOption(*command_, options_.repeat);
    addBackendOption(*command_, options_.backend);
    addReportOptions(*command_, paths_);
    command_->footer(
        "Examples:\n"
        "  relievo-bench shadow --samples pillars --methods soft,horizon --elevations 15\n"
        "  relievo-bench shadow --markdown shadow.md --json shadow.json");
}

void ShadowCommand::run() const {
    ReportFiles files(paths_);
    const ShadowReport report = measureShadows(options_);
    const ReportTable table = shadowTable(report.measurements);
    commands::answer(formatTable(table));
    std::vector<ReportSection> sections = summariseShadows(report.measurements);
    sections.push_back({"Every relief", "On " + report.renderer + ".", table});
    files.write({.json = {{"benchmark", "shadow"},
                          {"version", textures::kVersion},
                          {"renderer", report.renderer},
                          {"technique", options_.technique},
                          {"size", options_.size},
                          {"frame", options_.frame},
                          {"lightRays", options_.lightRays},
                          {"viewElevation", options_.viewElevation},
                          {"depthScale", options_.depthScale},
                          {"repeat", options_.repeat},
                          {"rows", rowsAsJson(table)}},
                 .plot = shadowPlot(report.measurements),
                 .title = "relievo-bench shadow",
                 .sections = std::move(sections)});
}

}  // namespace relievo::bench
