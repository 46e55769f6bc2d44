#pragma once

#include <string>
#include <vector>

#include "textures/plane.h"
#include "viewer/measured_frame.h"
#include "viewer/picture.h"
#include "viewer/reference_frame.h"

namespace relievo::viewer {

/// What is wrong at one pixel, besides a distance.
enum class PixelVerdict {
    Uncovered = -1,  ///< no surface there
    Compared = 0,    ///< technique and reference both hit, or both miss
    Mismatch = 1,    ///< one of them hits, the other misses
    Exhausted = 2,   ///< the technique ran out of steps
};

/// The error of one technique at every pixel, rows from the top.
struct ErrorImage {
    textures::Plane distance;  ///< along the ray, in texels (1/W tile widths), signed: behind > 0
    textures::Plane normalAngle;  ///< degrees
    textures::Plane verdict;      ///< PixelVerdict as a number
    textures::Plane steps;
    textures::Plane fetches;
};

ErrorImage makeErrorImage(const MeasuredFrame& frame, const ReferenceFrame& reference,
                          const textures::DepthMap& map, double depthScale);

/// The planes under the names `prefix.distance`, `prefix.normal_angle`, `prefix.verdict`,
/// `prefix.steps`, `prefix.fetches`, for writeChannels.
std::vector<NamedPlane> namedPlanes(const ErrorImage& image, const std::string& prefix);

}  // namespace relievo::viewer
