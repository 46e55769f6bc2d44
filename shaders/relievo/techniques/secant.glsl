// Secant search alone, over the whole ray: like binary search, but the next sample is where the line
// through the ends crosses (thesis 2.3.2). Quick on even slopes, slow where one end stays.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/whole_ray.glsl"
#include "relievo/search/secant.glsl"
