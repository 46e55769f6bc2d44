// Second phase by halving: the point in the solid is at most 1/2ⁿ of the bracket behind the crossing.
#include "relievo/search/bracket.glsl"

uniform int relievoBinarySteps;

float reliefRefine(ReliefRay ray, ReliefBracket bracket, inout int steps) {
    for (int i = 0; i < relievoBinarySteps; ++i) {
        ++steps;
        reliefNarrow(ray, 0.5 * (bracket.outside + bracket.inside), bracket);
    }
    return bracket.inside;
}
