#include "bench/render_command.h"

#include <map>

#include "bench/benchmark_options.h"
#include "commands/program.h"
#include "materials/technique_registry.h"
#include "textures/version.h"

namespace relievo::bench {

RenderCommand::RenderCommand(CLI::App& app)
    : m_command(app.add_subcommand(
          "render", "Time, work and error of every search technique and step budget")) {
    for (const materials::Technique& technique : materials::techniques())
        m_options.techniques.emplace_back(technique.name);
    addSamplesOption(*m_command, m_options.samples);
    addNamesOption(*m_command, "--techniques", m_options.techniques, "Search techniques");
    const auto add = [this](const char* name, auto& value, const char* description) {
        return m_command->add_option(name, value, description)->capture_default_str();
    };
    add("--elevations", m_options.elevations, "Degrees of the rays above the surface")
        ->delimiter(',')
        ->check(CLI::Range(0.001, 90.0));
    add("--steps", m_options.steps, "Step budgets, for techniques that have one")
        ->delimiter(',')
        ->check(CLI::Range(1, 4096));
    add("--size", m_options.size, "Texels of the reliefs on a side")->check(CLI::Range(1, 8192));
    add("--frame", m_options.frame, "Pixels of the frames on a side")->check(CLI::Range(1, 8192));
    add("--depth-scale", m_options.depthScale, "Depth of the reliefs in tile widths")
        ->check(CLI::Range(1e-6, 1e3));
    add("--azimuth", m_options.azimuth, "Degrees of the rays around the surface's normal")
        ->check(CLI::Range(-360.0, 360.0));
    addRepeatOption(*m_command, m_options.repeat);
    m_command->add_option("--backend", m_options.backend, "OpenGL through osmesa, egl or glfw")
        ->type_name("NAME")
        ->default_str("osmesa")
        ->transform(CLI::CheckedTransformer(
                        std::map<std::string, gl::Backend>{{"osmesa", gl::Backend::OSMesa},
                                                           {"egl", gl::Backend::Egl},
                                                           {"glfw", gl::Backend::Glfw}})
                        .description(""));
    m_command->add_option("--plot-against", m_plotAgainst, "Plot errors against time or fetches")
        ->type_name("NAME")
        ->default_str("time")
        ->transform(CLI::CheckedTransformer(
                        std::map<std::string, PlotAgainst>{{"time", PlotAgainst::Time},
                                                           {"fetches", PlotAgainst::Fetches}})
                        .description(""));
    addReportOptions(*m_command, m_paths);
    m_command->footer(
        "Examples:\n"
        "  relievo-bench render --samples noise --techniques relief,cone --elevations 45,15\n"
        "  relievo-bench render --steps 16,64,256 --json render.json --plot render.svg");
}

void RenderCommand::run() const {
    ReportFiles files(m_paths);
    const RenderReport report = measureRender(m_options);
    const ReportTable table = renderTable(report.measurements);
    commands::answer(formatTable(table));
    files.write({{"benchmark", "render"},
                 {"version", textures::kVersion},
                 {"renderer", report.renderer},
                 {"size", m_options.size},
                 {"frame", m_options.frame},
                 {"depthScale", m_options.depthScale},
                 {"azimuth", m_options.azimuth},
                 {"repeat", m_options.repeat},
                 {"rows", rowsAsJson(table)}},
                renderPlot(report.measurements, m_plotAgainst));
}

}  // namespace relievo::bench
