#include "bench/sheet_view.h"

#include "viewer/camera.h"

namespace relievo::bench {

viewer::View sheetView(const SheetOptions& options, float lightElevation) {
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
    view.toLight = viewer::directionTowards(azimuth - 100.0f, lightElevation);
    // The quad is one unit wide.
    view.depthScale = static_cast<float>(options.depthScale);
    view.window = {0.0f, 0.0f, kSheetTiles.x, kSheetTiles.y};
    view.markExhausted = true;
    return view;
}

viewer::Picture pictureIn(const gl::Framebuffer& target) {
    viewer::Picture picture(target.width(), target.height());
    picture.rgba = target.read(0);
    return picture;
}

viewer::Picture sheetOf(const std::vector<viewer::SheetCell>& cells, int columns) {
    std::vector<std::vector<viewer::SheetCell>> rows(1);
    for (const viewer::SheetCell& cell : cells) {
        if (static_cast<int>(rows.back().size()) == columns)
            rows.emplace_back();
        rows.back().push_back(cell);
    }
    return viewer::makeContactSheet(rows, {});
}

}  // namespace relievo::bench
