// Two points of a ray with the surface between them.
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"

struct ReliefBracket {
    float outside;  // t of a point above the surface
    float inside;   // t of a later one in the solid
    float above;    // how far the first is above the surface, in depth
    float below;    // how far the second is below it
};

// The stretch of a ray between two t. It is a bracket unless its end is above the surface (below < 0).
ReliefBracket reliefStretch(ReliefRay ray, float from, float to) {
    vec3 start = reliefPoint(ray, from);
    vec3 end = reliefPoint(ray, to);
    return ReliefBracket(from, to, reliefDepth(start.xy) - start.z, end.z - reliefDepth(end.xy));
}

// Moves one end of the bracket to t, between them.
void reliefNarrow(ReliefRay ray, float t, inout ReliefBracket bracket) {
    vec3 point = reliefPoint(ray, t);
    float below = point.z - reliefDepth(point.xy);
    if (below >= 0.0) {
        bracket.inside = t;
        bracket.below = below;
    } else {
        bracket.outside = t;
        bracket.above = -below;
    }
}

// Where the line through the ends' heights crosses the surface: at the start when that is in the solid
// already. The ends may both lie on the surface.
float reliefSecant(ReliefBracket bracket) {
    float both = bracket.above + bracket.below;
    float share = both > 0.0 ? max(bracket.above / both, 0.0) : 0.0;
    return mix(bracket.outside, bracket.inside, share);
}
