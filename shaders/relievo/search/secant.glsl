// Second phase by lines (regula falsi): again and again the crossing of the line through both ends becomes
// one of them. Quick where the surface is even, slow where one end stays.
#include "relievo/search/bracket.glsl"

uniform int relievoSecantSteps;

float reliefRefine(ReliefRay ray, ReliefBracket bracket, inout int steps) {
    for (int i = 0; i < relievoSecantSteps; ++i) {
        ++steps;
        reliefNarrow(ray, reliefSecant(bracket), bracket);
    }
    return reliefSecant(bracket);
}
