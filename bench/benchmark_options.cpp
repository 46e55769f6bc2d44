#include "bench/benchmark_options.h"

#include <fmt/format.h>

#include <map>

#include "textures/sample_reliefs.h"

namespace relievo::bench {

void addNamesOption(CLI::App& command, const std::string& option, std::vector<std::string>& chosen,
                    const std::string& description) {
    // The list stands in the text once, instead of in the type and in the default.
    command
        .add_option(option, chosen, fmt::format("{}, of: {}", description, fmt::join(chosen, ", ")))
        ->delimiter(',')
        ->check(CLI::IsMember(chosen).description(""))
        ->type_name("NAME,...")
        ->default_str("all");
}

void addSamplesOption(CLI::App& command, std::vector<std::string>& samples) {
    samples.clear();
    for (const textures::SampleRelief& sample : textures::sampleReliefs())
        samples.emplace_back(sample.name);
    addNamesOption(command, "--samples", samples, "Generated reliefs");
}

void addRepeatOption(CLI::App& command, int& repeat) {
    command.add_option("--repeat", repeat, "Runs of each measurement, of which the fastest counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
}

void addBackendOption(CLI::App& command, gl::Backend& backend) {
    command.add_option("--backend", backend, "OpenGL through osmesa, egl or glfw")
        ->type_name("NAME")
        ->default_str("osmesa")
        ->transform(CLI::CheckedTransformer(
                        std::map<std::string, gl::Backend>{{"osmesa", gl::Backend::OSMesa},
                                                           {"egl", gl::Backend::Egl},
                                                           {"glfw", gl::Backend::Glfw}})
                        .description(""));
}

void addPlotAgainstOption(CLI::App& command, PlotAgainst& against) {
    command.add_option("--plot-against", against, "Plot errors against time or fetches")
        ->type_name("NAME")
        ->default_str("time")
        ->transform(CLI::CheckedTransformer(
                        std::map<std::string, PlotAgainst>{{"time", PlotAgainst::Time},
                                                           {"fetches", PlotAgainst::Fetches}})
                        .description(""));
}

void addReportOptions(CLI::App& command, ReportPaths& paths) {
    command.add_option("--json", paths.json, "Write the report to this file as JSON")
        ->type_name("FILE");
    command.add_option("--markdown", paths.markdown, "Write tables to this file as Markdown")
        ->type_name("FILE.md");
    command
        .add_option("--plot", paths.plot, "Draw the report to this SVG or PNG file, with gnuplot")
        ->type_name("FILE.svg|FILE.png");
}

}  // namespace relievo::bench
