#pragma once

#include <cassert>
#include <cstddef>
#include <numbers>

namespace relievo::preprocess {

/// The most of each that a table of displacements may have.
inline constexpr int kMostElevations = 64;
inline constexpr int kMostCurvatures = 33;
inline constexpr std::size_t kMostViews = 16384;
/// The greatest of each; rays over deeper reliefs would be too long.
inline constexpr double kLargestSharpest = 100.0;
inline constexpr double kLargestViewScale = 10.0;

/// The views for which the displacements of a relief are tabulated, and the base surface that it
/// lies on (view_displacement.h). Lengths are in tile widths.
struct ViewGrid {
    int azimuths = 16;   ///< of the way that the ray goes, from +u towards +v: azimuthOf
    int elevations = 8;  ///< evenly spread, without the level one and up to the vertical
    int curvatures =
        5;  ///< evenly spread from −sharpest to sharpest; odd: the plane is one of them
    double sharpest = 2.0;    ///< greatest curvature of the base, ≥ 0: radians per tile width
    double depthScale = 0.1;  ///< depth of D = 1, > 0

    [[nodiscard]] std::size_t views() const noexcept {
        return static_cast<std::size_t>(azimuths) * static_cast<std::size_t>(elevations) *
               static_cast<std::size_t>(curvatures);
    }
    /// The number of a view, by the numbers of its parts: azimuths follow each other, then
    /// elevations, then curvatures.
    [[nodiscard]] std::size_t view(int azimuth, int elevation, int curvature) const noexcept {
        assert(azimuth >= 0 && azimuth < azimuths && elevation >= 0 && elevation < elevations &&
               curvature >= 0 && curvature < curvatures);
        return static_cast<std::size_t>((curvature * elevations + elevation) * azimuths + azimuth);
    }
    /// Angle between the ray and the reference surface, in radians; the last one is π/2.
    [[nodiscard]] double elevationOf(int elevation) const noexcept {
        return std::numbers::pi / 2.0 * (elevation + 1) / elevations;
    }
    /// Curvature of the base along the ray; above 0 it falls away from the ray, like a ball.
    [[nodiscard]] double curvatureOf(int curvature) const noexcept {
        const int plane = curvatures / 2;
        return plane == 0 ? 0.0 : sharpest * (curvature - plane) / plane;
    }
};

}  // namespace relievo::preprocess
