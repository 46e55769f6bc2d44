// First phase by a given number of equal steps.
#include "relievo/search/march.glsl"

uniform int relievoLinearSteps;

int reliefFind(ReliefRay ray, out ReliefBracket bracket, inout int steps) {
    return reliefMarch(ray, relievoLinearSteps, bracket, steps);
}
