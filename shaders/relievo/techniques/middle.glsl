// What a relief looks like from so far away that the plane halfway through it is as good as the relief:
// normal mapping on that plane. Error: half of the greatest difference of depths. Cost: nothing.
#include "relievo/search/middle.glsl"

ReliefHit searchRelief(ReliefRay ray) { return reliefMiddle(ray); }
