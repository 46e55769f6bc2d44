// Extrusions and extended ones as they were printed (Halli 2009, algorithms 4.1 and 4.2): steps by the distance
// to the shape.
//
// Error: in front of the surface where the steps run out, most of all on rays that pass close by a wall; steps
// of bilinear distances are a little too long. Cost: one lookup a step.
#include "relievo/solid/printed.glsl"

SolidHit searchSolid(SolidRay ray) {
    SolidPath path = solidPath(ray, 0);
    float extension = solidPieces[0].line.z;
    float t = path.enter;
    solidStepToExtension(path, extension, t);
    return solidPrintedHit(ray, path, t, solidPrintedRest(path, extension, t), vec2(1.0, 0.0));
}
