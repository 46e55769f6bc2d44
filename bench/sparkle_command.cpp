#include "bench/sparkle_command.h"

#include <fmt/format.h>

#include <utility>

#include "bench/benchmark_options.h"
#include "commands/program.h"
#include "textures/version.h"
#include "viewer/contact_sheet.h"

namespace relievo::bench {
namespace {

// A row a sample: the truth, and each technique in all ways.
viewer::Picture sheetOf(const SparkleReport& report) {
    std::vector<std::vector<viewer::SheetCell>> rows;
    for (const SparkleMeasurement& m : report.measurements) {
        if (rows.empty() || rows.back().front().subtitle != m.sample)
            rows.push_back({{report.truths[rows.size()], "supersampled", m.sample}});
        rows.back().push_back(
            {m.picture, m.technique + (m.hasLevels ? ", levels" : ""),
             fmt::format("{} rays, sparkle {:.1f} %", m.rays, 100.0 * m.errors.sparkle)});
    }
    return viewer::makeContactSheet(rows, {});
}

}  // namespace

SparkleCommand::SparkleCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "sparkle",
          "What comes and goes on a receding plane while a camera turns, with and "
          "without MIP levels and several rays a pixel")) {
    addSamplesOption(*command_, options_.samples);
    addNamesOption(*command_, "--techniques", options_.techniques, "Search techniques");
    const auto add = [this](const char* name, auto& value, const char* description) {
        return command_->add_option(name, value, description)->capture_default_str();
    };
    add("--frames", options_.frames, "Frames of the camera's turn")->check(CLI::Range(2, 1000));
    add("--size", options_.size, "Texels of the reliefs on a side")->check(CLI::Range(1, 8192));
    add("--frame", options_.frame, "Pixels of the frames on a side")->check(CLI::Range(1, 1024));
    add("--rays", options_.rays, "Rays in a pixel, where there are several")
        ->check(CLI::Range(2, 64));
    add("--supersampling", options_.supersampling,
        "Exact rays of the truth in a pixel, along each axis")
        ->check(CLI::Range(1, 16));
    add("--tiles", options_.tiles, "Tiles across the plane")->check(CLI::Range(1, 4096));
    add("--depth-scale", options_.depthScale, "Depth of the reliefs in tile widths")
        ->check(CLI::Range(1e-6, 1e3));
    add("--elevation", options_.elevation, "Degrees of the middle of the frame below the horizon")
        ->check(CLI::Range(11.0, 80.0));
    addRepeatOption(*command_, options_.repeat);
    command_
        ->add_option("--picture", picture_,
                     "Write the first frames beside the supersampled ones to this picture")
        ->type_name("FILE.png");
    addReportOptions(*command_, paths_);
    command_->footer(
        "Examples:\n"
        "  relievo-bench sparkle --samples noise,bricks --techniques exact\n"
        "  relievo-bench sparkle --frames 32 --supersampling 16 --picture sparkle.png");
}

void SparkleCommand::run() const {
    ReportFiles files(paths_);
    if (!picture_.empty())
        viewer::requirePictureFile(picture_);
    const SparkleReport report = measureSparkle(options_);
    const ReportTable table = sparkleTable(report.measurements);
    commands::answer(formatTable(table));
    if (!picture_.empty())
        viewer::writePicture(picture_, sheetOf(report));
    files.write({.json = {{"benchmark", "sparkle"},
                          {"version", textures::kVersion},
                          {"renderer", report.renderer},
                          {"size", options_.size},
                          {"frame", options_.frame},
                          {"frames", options_.frames},
                          {"supersampling", options_.supersampling},
                          {"tiles", options_.tiles},
                          {"depthScale", options_.depthScale},
                          {"elevation", options_.elevation},
                          {"rows", rowsAsJson(table)}},
                 .plot = sparklePlot(report.measurements),
                 .title = "relievo-bench sparkle",
                 .sections = {{"Mean over the reliefs", "", meanSparkleTable(report.measurements)},
                              {"Every relief", "On " + report.renderer + ".", table}}});
}

}  // namespace relievo::bench
