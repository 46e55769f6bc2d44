#pragma once

#include <string>
#include <vector>

#include "gl/context.h"
#include "gl/framebuffer.h"
#include "surfaces/surface_mesh.h"
#include "viewer/contact_sheet.h"
#include "viewer/picture.h"
#include "viewer/scene_renderer.h"

namespace relievo::bench {

/// What sheets of pictures show: a quad of 2×2 tiles of a sample relief, close up.
struct SheetOptions {
    std::string sample = "cobbles";  ///< one of textures::sampleReliefs
    int size = 256;                  ///< the relief is size×size texels
    int width = 384;                 ///< of each picture, in pixels
    int height = 256;
    int columns = 4;
    double elevation = 14.0;  ///< degrees of the eye above the surface
    double azimuth = 20.0;
    double depthScale = 0.12;  ///< in tile widths
    gl::Backend backend = gl::Backend::OSMesa;
};

inline constexpr surfaces::Tiles kSheetTiles{2.0f, 2.0f};

/// The view of a sheet's pictures, lit from `lightElevation` degrees, a right angle and a little
/// more beside the eye.
viewer::View sheetView(const SheetOptions& options, float lightElevation);

/// The colours of a framebuffer.
viewer::Picture pictureIn(const gl::Framebuffer& target);

/// The cells as a sheet with so many in a row.
viewer::Picture sheetOf(const std::vector<viewer::SheetCell>& cells, int columns);

}  // namespace relievo::bench
