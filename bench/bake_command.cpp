#include "bench/bake_command.h"

#include "bench/bake_builders.h"
#include "bench/benchmark_options.h"
#include "commands/program.h"
#include "textures/version.h"

namespace relievo::bench {

BakeCommand::BakeCommand(CLI::App& app)
    : command_(app.add_subcommand("bake", "Time per texel of every map builder against size")) {
    for (const BakeBuilder& builder : bakeBuilders())
        options_.builders.emplace_back(builder.name);
    addSamplesOption(*command_, options_.samples);
    addNamesOption(*command_, "--builders", options_.builders, "Map builders");
    command_->add_option("--sizes", options_.sizes, "Sizes N of the N×N maps, in texels")
        ->delimiter(',')
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    addRepeatOption(*command_, options_.repeat);
    command_->add_option("--threads", options_.threads, "At most so many threads; 0: all cores")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    addReportOptions(*command_, paths_);
    command_->footer(
        "Examples:\n"
        "  relievo-bench bake --samples noise,ridge --sizes 256,512,1024\n"
        "  relievo-bench bake --builders cones-texel --threads 1 --json bake.json --plot bake.svg");
}

void BakeCommand::run() const {
    ReportFiles files(paths_);
    const std::vector<BakeMeasurement> measurements = measureBake(options_);
    const ReportTable table = bakeTable(measurements);
    commands::answer(formatTable(table));
    files.write({{"benchmark", "bake"},
                 {"version", textures::kVersion},
                 {"repeat", options_.repeat},
                 {"threads", allowedThreads(options_)},
                 {"rows", rowsAsJson(table)}},
                bakePlot(measurements));
}

}  // namespace relievo::bench
