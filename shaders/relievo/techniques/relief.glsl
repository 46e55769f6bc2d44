// Relief mapping: linear search, then binary search within the step that pierced the surface
// (Policarpo, Oliveira, Comba 2005). The first hit is missed where the linear search steps over it.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/linear.glsl"
#include "relievo/search/binary.glsl"
