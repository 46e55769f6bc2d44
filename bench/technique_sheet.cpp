#include "bench/technique_sheet.h"

#include <fmt/format.h>

#include "bench/sample_stages.h"
#include "commands/progress.h"
#include "materials/technique_registry.h"
#include "reference/error_metrics.h"
#include "viewer/camera.h"
#include "viewer/contact_sheet.h"
#include "viewer/reference_frame.h"

namespace relievo::bench {
namespace {

constexpr surfaces::Tiles kTiles{2.0f, 2.0f};

viewer::View viewOf(const TechniqueSheetOptions& options) {
    viewer::View view;
    const auto azimuth = static_cast<float>(options.azimuth);
    // Near enough that the quad fills the frame, and a little below its middle, so that the far
    // edge is in it.
    const viewer::OrbitCamera orbit{.azimuth = azimuth,
                                    .elevation = static_cast<float>(options.elevation),
                                    .distance = 0.6f,
                                    .fieldOfView = 30.0f,
                                    .target = 0.12f * viewer::directionTowards(azimuth, 0.0f)};
    view.camera = viewer::perspectiveCamera(
        orbit, static_cast<float>(options.width) / static_cast<float>(options.height));
    view.toLight = viewer::directionTowards(azimuth - 100.0f, 35.0f);
    // The quad is one unit wide.
    view.depthScale = static_cast<float>(options.depthScale);
    view.window = {0.0f, 0.0f, kTiles.x, kTiles.y};
    view.markExhausted = true;
    return view;
}

viewer::Picture pictureIn(const gl::Framebuffer& target) {
    viewer::Picture picture(target.width(), target.height());
    picture.rgba = target.read(0);
    return picture;
}

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

viewer::Picture makeTechniqueSheet(const TechniqueSheetOptions& options) {
    const auto context = gl::createContext(options.backend);
    SampleStages stages(options.sample, {options.size, options.width, options.height, kTiles});
    const viewer::View view = viewOf(options);
    SampleStage& first = stages.of(materials::findTechnique("normal"));
    const viewer::ReferenceFrame exact = first.renderer.trace(view, options.width, options.height);

    std::vector<std::vector<viewer::SheetCell>> rows(1);
    const auto add = [&](viewer::SheetCell cell) {
        if (static_cast<int>(rows.back().size()) == options.columns)
            rows.emplace_back();
        rows.back().push_back(std::move(cell));
    };
    commands::Progress progress("pictures", options.techniques.size());
    for (const std::string& name : options.techniques) {
        const materials::Technique& technique = materials::findTechnique(name);
        add(techniqueCell(stages.of(technique), technique, view, exact));
        progress.advance();
    }
    first.renderer.drawReference(exact, view, first.target);
    add({pictureIn(first.target), "exact reference", "first hits in double precision"});
    return viewer::makeContactSheet(rows, {});
}

}  // namespace relievo::bench
