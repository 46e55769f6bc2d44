#pragma once

#include "reference/plane_outline.h"

namespace relievo::reference {

/// How far polylines of sample outlines are from the curves they stand for, at most: 1e-6 texels of
/// a map 512 wide, in tile widths.
inline constexpr double kSampleTolerance = 1e-6 / 512.0;

/// A circle as an inscribed polyline within `tolerance` of it.
OutlineContour circleContour(const glm::dvec2& centre, double radius,
                             double tolerance = kSampleTolerance);

/// Plane shapes in a tile of aspect 1, for extrusions. The names: "disc", "annulus", "star" (five
/// sharp points of 36°, turned a little off the axes), "comb" (bars from 3 texels of a map 512 wide
/// down to 0.75, and slits alike).
/// Sections in (s, z) of revolutions, s = 0 the axis, drawn on both sides of it: "cone", "torus",
/// "sphere", "vase" (a smooth spline with a hollow).
struct SampleOutline {
    const char* name;
    std::vector<OutlineContour> contours;
    Filling filling = Filling::NonZero;
};

std::vector<SampleOutline> sampleShapes();
std::vector<SampleOutline> sampleSections();

/// What the sections above stand for, in closed form.
struct SphereSection {
    static constexpr double kHeight = 0.5;  ///< z of the centre
    static constexpr double kRadius = 0.375;
};
struct TorusSection {
    static constexpr double kHeight = 0.5;
    static constexpr double kRing = 0.3;   ///< from the axis to the centre of the tube
    static constexpr double kTube = 0.11;  ///< its radius
};
struct ConeSection {
    static constexpr double kTop = 0.1;     ///< z of the apex
    static constexpr double kBottom = 0.9;  ///< z of the base
    static constexpr double kRadius = 0.4;  ///< of the base
};

}  // namespace relievo::reference
