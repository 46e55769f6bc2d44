#include "bench/technique_sheet.h"

#include <fmt/format.h>

#include "bench/sample_stages.h"
#include "commands/progress.h"
#include "materials/technique_registry.h"
#include "reference/error_metrics.h"
#include "viewer/reference_frame.h"

namespace relievo::bench {
namespace {

viewer::SheetCell techniqueCell(SampleStage& stage, const materials::Technique& technique,
                                const viewer::View& view, const viewer::ReferenceFrame& exact) {
    materials::ReliefMaterial material = stage.renderer.makeMaterial(technique);
    stage.renderer.draw(material, view, stage.target);
    const viewer::MeasuredFrame frame =
        stage.renderer.measure(material, view, stage.target.width(), stage.target.height());
    const textures::DepthMap& map = stage.renderer.depthMap();
    const reference::ErrorStatistics errors = reference::summarizeErrors(
        viewer::compareFrames(frame, exact, map, static_cast<double>(view.depthScale)),
        1.0 / map.width());
    return {pictureIn(stage.target), std::string(technique.title),
            fmt::format("{}: {:.3g} % wrong, {:.1f} lookups", technique.name,
                        100 * errors.wrongShare, viewer::countWork(frame).meanFetches)};
}

}  // namespace

viewer::Picture makeTechniqueSheet(const SheetOptions& options,
                                   const std::vector<std::string>& techniques) {
    constexpr float kLightElevation = 35.0f;
    const auto context = gl::createContext(options.backend);
    SampleStages stages(options.sample, {options.size, options.width, options.height, kSheetTiles});
    const viewer::View view = sheetView(options, kLightElevation);
    SampleStage& first = stages.of(materials::findTechnique("normal"));
    const viewer::ReferenceFrame exact = first.renderer.trace(view, options.width, options.height);

    std::vector<viewer::SheetCell> cells;
    commands::Progress progress("pictures", techniques.size());
    for (const std::string& name : techniques) {
        const materials::Technique& technique = materials::findTechnique(name);
        cells.push_back(techniqueCell(stages.of(technique), technique, view, exact));
        progress.advance();
    }
    first.renderer.drawReference(exact, view, first.target);
    cells.push_back({pictureIn(first.target), "exact reference", "first hits in double precision"});
    return sheetOf(cells, options.columns);
}

}  // namespace relievo::bench
