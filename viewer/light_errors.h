#pragma once

#include <cstddef>

#include "textures/plane.h"
#include "viewer/measured_frame.h"
#include "viewer/reference_frame.h"

namespace relievo::viewer {

/// How wrong the shadows of a frame are, over the pixels in which both it and the exact frame hit.
struct LightErrors {
    std::size_t pixels = 0;
    double wrongShare = 0.0;   ///< of the pixels: off by over kWrongLight of the light
    double meanError = 0.0;    ///< shares of the light, absolute
    double meanFetches = 0.0;  ///< lookups of the shadow method a pixel
};

/// A pixel is wrong when it gets this share of the light too much, or too little.
inline constexpr double kWrongLight = 0.1;

/// Compares the shares of the light; both frames must have one size, and the exact one shadows.
LightErrors summarizeLight(const MeasuredFrame& frame, const ReferenceFrame& exact);

/// The share of the light that each pixel gets too much, rows from the top; 0 where not both hit.
textures::Plane lightErrorPlane(const MeasuredFrame& frame, const ReferenceFrame& exact);

}  // namespace relievo::viewer
