// Cone step mapping as it was published (Dummer 2006): what techniques/cone.glsl is measured against. Its
// hits are above the surface by up to the tolerance.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/cone_steps.glsl"
#include "relievo/search/binary.glsl"
