// Relaxed cone stepping as it was published (Policarpo, Oliveira 2007): what techniques/relaxed.glsl is
// measured against.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/cone_steps.glsl"
#include "relievo/search/binary.glsl"
