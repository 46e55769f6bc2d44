#include "bench/shadow_sheet.h"

#include <fmt/format.h>

#include <glm/trigonometric.hpp>

#include "bench/sample_stages.h"
#include "commands/progress.h"
#include "materials/shadow_registry.h"
#include "viewer/light_errors.h"
#include "viewer/reference_frame.h"

namespace relievo::bench {
namespace {

constexpr float kLightElevation = 22.0f;  // degrees
constexpr float kLightSize = 8.0f;
constexpr int kLightRays = 128;

// `method` is null for none.
viewer::SheetCell methodCell(SampleStage& stage, const materials::Technique& technique,
                             const materials::ShadowMethod* method, const viewer::View& view,
                             const viewer::ReferenceFrame& exact) {
    materials::ReliefMaterial material = stage.renderer.makeMaterial(technique);
    material.setShadow(method);
    stage.renderer.draw(material, view, stage.target);
    const viewer::LightErrors errors = viewer::summarizeLight(
        stage.renderer.measure(material, view, exact.width, exact.height), exact);
    return {pictureIn(stage.target), std::string(method ? method->title : "without shadows"),
            fmt::format("{}: {:.3g} % wrong, {:.1f} lookups", method ? method->name : "none",
                        100 * errors.wrongShare, errors.meanFetches)};
}

}  // namespace

viewer::Picture makeShadowSheet(const SheetOptions& options) {
    const auto context = gl::createContext(options.backend);
    SampleStages stages(options.sample, {options.size, options.width, options.height, kSheetTiles});
    viewer::View view = sheetView(options, kLightElevation);
    view.lightRadius = glm::radians(kLightSize / 2.0f);
    view.lightRays = kLightRays;
    const materials::Technique& technique = materials::findTechnique("exact");
    SampleStage& first = stages.of(technique);
    const viewer::ReferenceFrame exact = first.renderer.trace(view, options.width, options.height);

    std::vector<viewer::SheetCell> cells = {methodCell(first, technique, nullptr, view, exact)};
    commands::Progress progress("pictures", materials::shadowMethods().size());
    for (const materials::ShadowMethod& method : materials::shadowMethods()) {
        cells.push_back(methodCell(stages.of(technique, &method), technique, &method, view, exact));
        progress.advance();
    }
    first.renderer.drawReference(exact, view, first.target);
    cells.push_back({pictureIn(first.target), "exact shadows",
                     fmt::format("{} rays a pixel in double precision", kLightRays)});
    return sheetOf(cells, options.columns);
}

}  // namespace relievo::bench
