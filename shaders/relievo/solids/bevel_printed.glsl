// Bevelled extrusions as they were printed (Halli 2009, algorithm 4.3): steps by the distance to the shape
// that the bevel is of, then halvings.
//
// Error: a step can lead through a bevel that the ray enters and leaves, so that what is behind is hit. Where
// the steps run out the halvings go on in front of the surface. Cost: one lookup a step.
#include "relievo/solid/printed_bevel.glsl"

SolidHit searchSolid(SolidRay ray) {
    SolidPath path = solidPath(ray, 0);
    SolidBevel bevel = solidPrintedBevel();
    float t = path.enter;
    solidStepToBevel(path, bevel, t);
    return solidPrintedHit(ray, path, t, solidPrintedBevelRest(path, bevel, t), solidPieces[0].normals.xy);
}
