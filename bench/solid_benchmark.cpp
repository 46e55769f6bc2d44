#include "bench/solid_benchmark.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "bench/solid_models.h"
#include "bench/solid_stages.h"
#include "commands/progress.h"
#include "materials/solid_registry.h"
#include "materials/technique_registry.h"

namespace relievo::bench {
namespace {

// What the thesis compares its extrusions with (table 4.2), cone tracing in our form as well, and
// the best search of reliefs, which shows how far a relief is from the solid.
constexpr std::array<std::string_view, 5> kReliefTechniques{"relief", "parallax-occlusion",
                                                            "cone-step", "cone", "exact"};

bool isReliefTechnique(std::string_view name) {
    return std::ranges::find(kReliefTechniques, name) != kReliefTechniques.end();
}

const materials::Technique& techniqueOf(const std::string& name) {
    return isReliefTechnique(name) ? materials::findTechnique(name)
                                   : materials::findSolidTechnique(name).technique;
}

bool isShownBy(const std::string& technique, const solids::SolidPart& part) {
    if (isReliefTechnique(technique))
        return part.solid.kind == solids::SolidKind::Extrusion;
    return materials::solidProblem(materials::findSolidTechnique(technique), {{part}}).empty();
}

// One search with one budget.
struct Job {
    std::string technique;
    std::optional<int> steps;
    bool isDefault = false;
};

std::vector<Job> jobsOf(const SolidBenchmarkOptions& options, const solids::SolidPart& part) {
    std::vector<Job> jobs;
    for (const std::string& name : options.techniques) {
        if (!isShownBy(name, part))
            continue;
        const auto* const budget = materials::budgetParameter(techniqueOf(name));
        if (budget == nullptr) {
            jobs.push_back({name, std::nullopt, true});
            continue;
        }
        std::vector<int> budgets = options.steps;
        std::erase_if(budgets, [budget](int steps) {
            return steps < budget->minimum || steps > budget->maximum;
        });
        const int normal = static_cast<int>(budget->defaultValue);
        if (std::ranges::find(budgets, normal) == budgets.end())
            budgets.insert(std::ranges::upper_bound(budgets, normal), normal);
        for (const int steps : budgets)
            jobs.push_back({name, steps, steps == normal});
    }
    return jobs;
}

// A solid to be measured.
struct Case {
    std::string solid;
    std::string shape;
    int size = 0;
};

std::vector<Case> casesOf(const SolidBenchmarkOptions& options) {
    std::vector<Case> cases;
    for (const int size : options.sizes)
        for (const std::string& solid : options.solids)
            for (const std::string& shape : options.shapes)
                if (fitsSolid(shape, solid))
                    cases.push_back({solid, shape, size});
    return cases;
}

// The shape maps, each baked once.
class Shapes {
  public:
    explicit Shapes(bool hasSharpCorners) : hasSharpCorners_(hasSharpCorners) {}

    std::shared_ptr<const textures::ShapeMap> get(const Case& which) {
        auto& shape = shapes_[{which.shape, which.size}];
        if (!shape)
            shape = makeSolidShape(which.shape, which.size, hasSharpCorners_);
        return shape;
    }

  private:
    bool hasSharpCorners_;
    std::map<std::pair<std::string, int>, std::shared_ptr<const textures::ShapeMap>> shapes_;
};

// A solid in both forms, with the exact first hits of the rays of each from one elevation: the same
// rays, but for the rounding of floats.
class CaseStage {
  public:
    CaseStage(viewer::FrameRenderer& frames, const solids::SolidPart& part)
        : truth_(part), solid_(frames, part) {
        if (part.solid.kind == solids::SolidKind::Extrusion)
            relief_.emplace(reliefOf(part.solid));
    }

    SolidMeasurement measure(const Job& job, const SolidSight& sight, int size, int repeat) {
        const bool isRelief = isReliefTechnique(job.technique);
        const SolidRun run = isRelief ? relief_->run(materials::findTechnique(job.technique),
                                                     job.steps, sight, repeat)
                                      : solid_.run(materials::findSolidTechnique(job.technique),
                                                   job.steps, sight, repeat);
        const SolidSpace space = solid_.space(sight);
        auto& exact = exact_[{isRelief, sight.elevation}];
        if (exact.empty())
            exact = truth_.trace(run.frame, space);
        const SolidErrors found = compareWithSolid(run.frame, exact, space, 1.0 / size);
        SolidMeasurement result;
        result.technique = job.technique;
        result.isRelief = isRelief;
        result.elevation = sight.elevation;
        result.steps = job.steps;
        result.isDefault = job.isDefault;
        result.size = size;
        result.seconds = run.seconds;
        result.work = viewer::countWork(run.frame);
        result.errors = found.errors;
        result.faults = found.faults;
        result.tiedShare = found.tiedShare;
        return result;
    }

  private:
    SolidTruth truth_;
    SolidStage solid_;
    std::optional<SolidReliefStages> relief_;
    std::map<std::pair<bool, double>, std::vector<RayTruth>> exact_;
};

std::size_t frameCount(const SolidBenchmarkOptions& options, Shapes& shapes) {
    std::size_t count = 0;
    for (const Case& which : casesOf(options))
        count += jobsOf(options, makeSolidModel(which.solid, shapes.get(which))).size();
    return count * options.elevations.size();
}

}  // namespace

std::vector<std::string> solidBenchmarkTechniques() {
    std::vector<std::string> names;
    for (const materials::SolidTechnique& technique : materials::solidTechniques())
        names.emplace_back(technique.technique.name);
    names.insert(names.end(), kReliefTechniques.begin(), kReliefTechniques.end());
    return names;
}

SolidReport measureSolids(const SolidBenchmarkOptions& options) {
    const auto context = gl::createContext(options.backend);
    viewer::FrameRenderer frames;
    Shapes shapes(options.corners == "sharp");
    SolidReport report{context->description(), {}};
    commands::Progress progress("frames", frameCount(options, shapes));
    for (const Case& which : casesOf(options)) {
        const solids::SolidPart part = makeSolidModel(which.solid, shapes.get(which));
        CaseStage stage(frames, part);
        for (const double elevation : options.elevations)
            for (const Job& job : jobsOf(options, part)) {
                SolidMeasurement measurement = stage.measure(
                    job, {elevation, options.azimuth, options.depthScale, options.frame},
                    which.size, options.repeat);
                measurement.solid = which.solid;
                measurement.shape = which.shape;
                report.measurements.push_back(std::move(measurement));
                progress.advance();
            }
    }
    return report;
}

ReportTable solidTable(const std::vector<SolidMeasurement>& measurements) {
    ReportTable table;
    table.columns = {{"solid", "solid"},
                     {"shape", "shape"},
                     {"size", "size"},
                     {"elevation", "elevation"},
                     {"technique", "technique"},
                     {"shownAs", "as"},
                     {"stepBudget", "budget"},
                     {"milliseconds", "ms"},
                     {"meanSteps", "steps"},
                     {"meanFetches", "fetches"},
                     {"wrongPercent", "wrong %", 3},
                     {"exhaustedPercent", "exhausted %", 3},
                     {"behindPercent", "behind %", 3},
                     {"lostPercent", "lost %", 3},
                     {"inFrontPercent", "in front %", 3},
                     {"tiedPercent", "tied %", 3},
                     {"meanDistanceTexels", "mean texels", 3}};
    for (const SolidMeasurement& m : measurements)
        table.rows.push_back(
            {m.solid, m.shape, std::int64_t{m.size}, m.elevation, m.technique,
             std::string(m.isRelief ? "relief" : "solid"),
             m.steps ? ReportCell(std::int64_t{*m.steps}) : ReportCell(), 1e3 * m.seconds,
             m.work.meanSteps, m.work.meanFetches, 100.0 * m.errors.wrongShare,
             100.0 * m.errors.unconvergedShare, 100.0 * m.faults.behind, 100.0 * m.faults.lost,
             100.0 * m.faults.inFront, 100.0 * m.tiedShare, m.size * m.errors.meanDistance});
    return table;
}

Plot solidPlot(const std::vector<SolidMeasurement>& measurements, PlotAgainst against) {
    struct Means {
        int count = 0;
        double cost = 0.0;
        double wrongPercent = 0.0;
    };
    std::map<std::tuple<std::string, std::string, std::optional<int>>, Means> means;
    Plot plot;
    plot.title = "Searches of solids, mean over shapes and elevations";
    plot.xLabel = against == PlotAgainst::Time ? "ms per frame" : "fetches per pixel";
    plot.yLabel = "wrong first hits in % (none: as half a ray)";
    plot.hasLegend = true;
    for (const SolidMeasurement& m : measurements) {
        Means& sum = means[{m.solid, m.technique, m.steps}];
        ++sum.count;
        sum.cost += against == PlotAgainst::Time ? 1e3 * m.seconds : m.work.meanFetches;
        // Logarithmic axes have no place for 0: no wrong hit is shown as half of one.
        const double fewest = 0.5 / static_cast<double>(std::max<std::size_t>(m.errors.rays, 1));
        sum.wrongPercent += 100.0 * std::max(m.errors.wrongShare, fewest);
        static_cast<void>(seriesOf(plot, m.solid, m.technique));  // in the order of the report
    }
    for (const auto& [key, sum] : means)
        if (sum.cost > 0.0)
            seriesOf(plot, std::get<0>(key), std::get<1>(key))
                .points.emplace_back(sum.cost / sum.count, sum.wrongPercent / sum.count);
    return plot;
}

}  // namespace relievo::bench
