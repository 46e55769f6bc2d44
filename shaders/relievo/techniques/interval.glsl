// Interval mapping: linear search, then secant search within the step that pierced the surface (Risser,
// Shah, Pattanaik 2006). It takes fewer refinements than relief mapping for the same error.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/linear.glsl"
#include "relievo/search/secant.glsl"
