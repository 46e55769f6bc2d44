#pragma once

#include <glm/vec3.hpp>
#include <limits>

namespace relievo::solids {

/// origin + t·direction, 0 ≤ t ≤ end. The direction has any length; a zero one is a point.
struct SolidRay {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, 1.0};
    double end = std::numeric_limits<double>::infinity();
};

/// Where a ray passes from outside to inside of a solid, or back.
enum class SolidFace {
    Wall,    ///< d = o(z) of an extrusion, d = e of a revolution
    Step,    ///< a level step between two pieces of a profile
    Cap,     ///< a border of the part's window, or of a replica of a revolution
    Origin,  ///< none: the ray begins inside
};

/// A ray going into a solid or out of it. Where it only touches one in a point there is none.
struct SolidCrossing {
    double t = 0.0;
    bool enters = true;
    SolidFace face = SolidFace::Wall;
    /// The gradient of the implicit function, out of the solid and of any length: a covector (it
    /// transforms with the inverse transpose). (0,0,0) at an Origin.
    glm::dvec3 outward{0.0};
};

/// What tracing has cost.
struct TraceCost {
    long cells = 0;  ///< bilinear cells (of one piece of the profile) in which roots were sought
    long jumps = 0;  ///< steps through space that the distance says to be free
};

/// The part of a ray that is in the window of a part, in its tile space.
struct WalkSpan {
    glm::dvec3 start{0.0};
    glm::dvec3 direction{0.0};
    double end = 0.0;    ///< parameter, from 0 at `start`
    int entryAxis = -1;  ///< of the border through which the ray comes in; −1: it begins inside
    int exitAxis = -1;   ///< of the border through which it goes out; −1: it ends inside
};

}  // namespace relievo::solids
