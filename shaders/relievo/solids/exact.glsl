// The first hit with the solid that the maps define (specification 7.2 and 7.3; ours): cells solved, empty
// space passed by safe steps, parts joined along the ray.
//
// Error: rounding of floats. Cost: a lookup a cell that is looked at.
#include "relievo/solid/compound.glsl"

SolidHit searchSolid(SolidRay ray) { return solidSearch(ray); }
