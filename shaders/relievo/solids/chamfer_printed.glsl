// Chamfered extrusions as they were printed (Halli 2009, algorithm 4.4): the search for the bevel and, when it
// ends below the chamfer, one for the shape that is as large as the chamfer ends. That goes on from where the
// first has ended: the text leaves it open, and from the start it would be stuck above chamfers.
//
// Error: that of the bevel's search, through chamfers that the ray enters and leaves. From below it hits the
// wall as if it reached to the top. Cost: one lookup a step of either search.
#include "relievo/solid/printed_bevel.glsl"

SolidHit searchSolid(SolidRay ray) {
    SolidPath path = solidPath(ray, 0);
    SolidBevel bevel = solidPrintedBevel();
    float t = path.enter;
    solidStepToBevel(path, bevel, t);
    if (solidPrintedDepth(path, t) < bevel.depth)
        return solidPrintedHit(ray, path, t, solidPrintedBevelRest(path, bevel, t), solidPieces[0].normals.xy);
    float extension = bevel.extension + bevel.slope * bevel.depth;
    solidStepToExtension(path, extension, t);
    return solidPrintedHit(ray, path, t, solidPrintedRest(path, extension, t), vec2(1.0, 0.0));
}
