#include "bench/bake_command.h"

#include "bench/benchmark_options.h"
#include "commands/program.h"
#include "textures/version.h"

namespace relievo::bench {

BakeCommand::BakeCommand(CLI::App& app)
    : m_command(app.add_subcommand("bake", "Time per texel of every map builder against size")) {
    for (const BakeBuilder& builder : bakeBuilders())
        m_options.builders.emplace_back(builder.name);
    addSamplesOption(*m_command, m_options.samples);
    addNamesOption(*m_command, "--builders", m_options.builders, "Map builders");
    m_command->add_option("--sizes", m_options.sizes, "Sizes N of the N×N maps, in texels")
        ->delimiter(',')
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    addRepeatOption(*m_command, m_options.repeat);
    m_command->add_option("--threads", m_options.threads, "At most so many threads; 0: all cores")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    addReportOptions(*m_command, m_paths);
    m_command->footer(
        "Examples:\n"
        "  relievo-bench bake --samples noise,ridge --sizes 256,512,1024\n"
        "  relievo-bench bake --builders cones-exact --threads 1 --json bake.json --plot bake.svg");
}

void BakeCommand::run() const {
    ReportFiles files(m_paths);
    const std::vector<BakeMeasurement> measurements = measureBake(m_options);
    const ReportTable table = bakeTable(measurements);
    commands::answer(formatTable(table));
    files.write({{"benchmark", "bake"},
                 {"version", textures::kVersion},
                 {"repeat", m_options.repeat},
                 {"threads", allowedThreads(m_options)},
                 {"rows", rowsAsJson(table)}},
                bakePlot(measurements));
}

}  // namespace relievo::bench
