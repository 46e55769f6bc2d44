#include "bench/search_command.h"

#include "bench/bake_summary.h"
#include "bench/benchmark_options.h"
#include "commands/program.h"
#include "textures/version.h"

namespace relievo::bench {

SearchCommand::SearchCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "search", "Lookups to the hit, and wrong hits, of every kind of map with its search")) {
    for (const SearchKind& kind : searchKinds())
        options_.searches.emplace_back(kind.name);
    addSamplesOption(*command_, options_.samples);
    addNamesOption(*command_, "--searches", options_.searches, "Kinds of maps with their searches");
    const auto add = [this](const char* name, auto& value, const char* description) {
        return command_->add_option(name, value, description)->capture_default_str();
    };
    add("--elevations", options_.elevations, "Degrees of the rays above the surface")
        ->delimiter(',')
        ->check(CLI::Range(0.001, 90.0));
    add("--size", options_.size, "Texels of the reliefs on a side")->check(CLI::Range(1, 8192));
    add("--rays", options_.rays, "Rays for each row")->check(CLI::Range(1, 100'000'000));
    add("--seed", options_.seed, "Other rays");
    add("--depth-scale", options_.depthScale, "Depth of the reliefs in tile widths")
        ->check(CLI::Range(1e-6, 1e3));
    addReportOptions(*command_, paths_);
    command_->footer(
        "Examples:\n"
        "  relievo-bench search --samples noise,blocks --size 512\n"
        "  relievo-bench search --searches relief,pyramid --json search.json --plot search.svg");
}

void SearchCommand::run() const {
    ReportFiles files(paths_);
    const std::vector<SearchMeasurement> measurements = measureSearches(options_);
    const ReportTable table = searchTable(measurements);
    commands::answer(formatTable(table));
    std::vector<ReportSection> sections = summariseSearches(measurements);
    sections.push_back({"Every relief", "", table});
    files.write({.json = {{"benchmark", "search"},
                          {"version", textures::kVersion},
                          {"size", options_.size},
                          {"rays", options_.rays},
                          {"seed", options_.seed},
                          {"depthScale", options_.depthScale},
                          {"rows", rowsAsJson(table)}},
                 .plot = searchPlot(measurements),
                 .title = "relievo-bench search",
                 .sections = std::move(sections)});
}

}  // namespace relievo::bench
