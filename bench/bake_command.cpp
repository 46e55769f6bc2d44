#include "bench/bake_command.h"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <algorithm>
#include <iterator>

#include "bench/bake_builders.h"
#include "bench/bake_summary.h"
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
    command_->add_flag("--no-limits", options_.hasNoLimits,
                       "Every builder at every size, however long it takes");
    command_->add_option("--threads", threads_, "At most so many threads; 0: all cores")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command_
        ->add_option("--strokes", strokes_,
                     "Strokes of a brush on the cones of each relief, of 1024² texels if that is "
                     "among the sizes, else of the largest")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    command_
        ->add_option("--rays", rays_,
                     "Rays for each row of relievo-bench search, which is run as well")
        ->check(CLI::Range(0, 100'000'000))
        ->capture_default_str();
    addReportOptions(*command_, paths_);
    command_->footer(
        "Examples:\n"
        "  relievo-bench bake --samples noise,ridge --sizes 256,512,1024\n"
        "  relievo-bench bake --builders cones-texel --threads 1 --json bake.json --plot "
        "bake.svg\n"
        "  relievo-bench bake --sizes 64,512,1024,2048,4096 --strokes 20 --rays 2000 --markdown "
        "bake.md");
}

std::vector<EditMeasurement> BakeCommand::measureStrokes() const {
    EditBenchmarkOptions edits;
    edits.samples = options_.samples;
    edits.size = sizeForComparison(options_.sizes);
    edits.strokes = strokes_;
    return strokes_ > 0 ? measureEdits(edits) : std::vector<EditMeasurement>{};
}

std::vector<SearchMeasurement> BakeCommand::measureRays() const {
    SearchBenchmarkOptions searches;
    searches.samples = options_.samples;
    for (const SearchKind& kind : searchKinds())
        searches.searches.emplace_back(kind.name);
    searches.size = std::min(searches.size, sizeForComparison(options_.sizes));
    searches.rays = rays_;
    return rays_ > 0 ? measureSearches(searches) : std::vector<SearchMeasurement>{};
}

void BakeCommand::run() const {
    ReportFiles files(paths_);
    const int threads = threads_ > 0 ? threads_ : oneapi::tbb::info::default_concurrency();
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(threads));
    Report report;
    report.title = fmt::format("relievo-bench bake, {} threads", threads);
    report.json = {{"benchmark", "bake"},
                   {"version", textures::kVersion},
                   {"repeat", options_.repeat},
                   {"threads", threads}};
    const auto add = [&report](const char* key, const ReportTable& table,
                               std::vector<ReportSection> sections) {
        if (table.rows.empty())
            return;
        commands::answer(formatTable(table));
        report.json[key] = rowsAsJson(table);
        std::ranges::move(sections, std::back_inserter(report.sections));
    };
    const std::vector<BakeMeasurement> builders = measureBake(options_);
    add("rows", bakeTable(builders), summariseBake(builders));
    report.plot = bakePlot(builders);
    const std::vector<EditMeasurement> edits = measureStrokes();
    add("strokes", editTable(edits), summariseEdits(edits));
    const std::vector<SearchMeasurement> searches = measureRays();
    add("searches", searchTable(searches), summariseSearches(searches));
    files.write(report);
}

}  // namespace relievo::bench
