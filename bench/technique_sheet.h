#pragma once

#include <string>
#include <vector>

#include "gl/context.h"
#include "viewer/picture.h"

namespace relievo::bench {

/// What a sheet of pictures shows: a quad of 2×2 tiles, close up, seen and lit at a low angle.
struct TechniqueSheetOptions {
    std::string sample = "cobbles";       ///< one of textures::sampleReliefs
    std::vector<std::string> techniques;  ///< names of the technique registry
    int size = 256;                       ///< the relief is size×size texels
    int width = 384;                      ///< of each picture, in pixels
    int height = 256;
    int columns = 4;
    double elevation = 14.0;  ///< degrees of the eye above the surface
    double azimuth = 20.0;
    double depthScale = 0.12;  ///< in tile widths
    gl::Backend backend = gl::Backend::OSMesa;
};

/// The same view by every technique with its default parameters, and by the exact hits, each with
/// its share of wrong first hits and its lookups. Magenta is where the steps ran out. Throws
/// gl::GlError when there is no context.
viewer::Picture makeTechniqueSheet(const TechniqueSheetOptions& options);

}  // namespace relievo::bench
