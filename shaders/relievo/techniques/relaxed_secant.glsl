// Relaxed cones as in techniques/relaxed.glsl, with secant search for the crossing: fewer samples where the
// surface is even.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/cones.glsl"
#include "relievo/search/secant.glsl"
