// Binary search alone, over the whole ray: finds some crossing of the surface, the first one only where
// there is no other (thesis 2.3.2).
#include "relievo/search/two_phases.glsl"
#include "relievo/search/whole_ray.glsl"
#include "relievo/search/binary.glsl"
