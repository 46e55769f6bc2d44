// The texture set and the shading model that the text asks for; see relievo/shading/.
//
// What the models share comes first: a file counts as included also where a branch leaves it out.
#include "relievo/shading/appearance.glsl"
#include "relievo/shading/surroundings.glsl"
#ifdef RELIEVO_MICROFACET
#include "relievo/shading/microfacet.glsl"
#else
#include "relievo/shading/blinn_phong.glsl"
#endif
