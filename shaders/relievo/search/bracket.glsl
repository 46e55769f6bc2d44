// Two points of a ray with the surface between them, and the searches that bring them together.
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"

struct ReliefBracket {
    float outside;  // t of a point above the surface
    float inside;   // t of a later one in the solid
    float above;    // how far the first is above the surface, in depth
    float below;    // how far the second is below it
};

// The whole ray as a bracket. False when its end lies above the surface, as far as its two ends tell.
bool reliefWholeRay(ReliefRay ray, out ReliefBracket bracket) {
    vec3 end = reliefPoint(ray, ray.end);
    bracket = ReliefBracket(0.0, ray.end, reliefDepth(ray.origin.xy) - ray.origin.z,
                            end.z - reliefDepth(end.xy));
    return bracket.below >= 0.0;
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

// Binary search: halves the bracket `count` times.
void reliefBisect(ReliefRay ray, int count, inout ReliefBracket bracket, inout int steps) {
    for (int i = 0; i < count; ++i) {
        ++steps;
        reliefNarrow(ray, 0.5 * (bracket.outside + bracket.inside), bracket);
    }
}

// Where the line through the ends' heights crosses the surface. The ends may both lie on it.
float reliefSecant(ReliefBracket bracket) {
    float both = bracket.above + bracket.below;
    float share = both > 0.0 ? bracket.above / both : 0.0;
    return mix(bracket.outside, bracket.inside, share);
}

// Secant search (regula falsi): `count` times the crossing of the line becomes an end of the bracket.
void reliefSecantSearch(ReliefRay ray, int count, inout ReliefBracket bracket, inout int steps) {
    for (int i = 0; i < count; ++i) {
        ++steps;
        reliefNarrow(ray, reliefSecant(bracket), bracket);
    }
}
