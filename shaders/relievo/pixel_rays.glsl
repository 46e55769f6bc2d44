// Several rays in a pixel that covers several texels, spread over all of what it covers. Where the view grazes
// a surface one pixel spans many texels of a level that is fine enough across the view, and a coarser
// level would flatten what stands up against the view. (Anisotropic filtering of textures does the same
// with lookups.)
//
// A program that traces one ray a pixel, without RELIEVO_PIXEL_RAYS, is as small as one without this.
#include "relievo/footprint.glsl"
#include "relievo/ray.glsl"

#ifdef RELIEVO_PIXEL_RAYS
uniform int relievoPixelRays;  // the most rays in a pixel
#endif

struct ReliefPixel {
    ReliefSurface surface;      // in the middle of the pixel
    ReliefFootprint footprint;  // of the pixel
    int rays;
    vec2 uvX;  // what a ray stands for, as derivatives for textureGrad
    vec2 uvY;
    mat2x3 position;  // from one end of the footprint to the other, and from one side to the other
    mat2 uv;
};

// The pixel around a point of a surface. To be called where neighbouring pixels come by too.
ReliefPixel reliefPixel(ReliefSurface surface, float aspect) {
    ReliefPixel pixel;
    pixel.surface = surface;
    pixel.footprint = reliefFootprint(surface.uv, aspect);
    pixel.rays = 1;
    pixel.uvX = dFdx(surface.uv);
    pixel.uvY = dFdy(surface.uv);
    pixel.position = mat2x3(0.0);
    pixel.uv = mat2(0.0);
#ifdef RELIEVO_PIXEL_RAYS
    // No more rays than the pixel covers texels of the first level: a near view takes one.
    float width = float(textureSize(relievoDepthMap, 0).x);
    float texels = pixel.footprint.longest * width * (pixel.footprint.shortest * width);
    pixel.rays = int(ceil(clamp(texels, 1.0, float(relievoPixelRays))));
    vec2 along = reliefLongestDirection(surface.uv, aspect);
    mat2 turn = mat2(along, vec2(-along.y, along.x));
    pixel.position = mat2x3(dFdx(surface.position), dFdy(surface.position)) * turn;
    pixel.uv = mat2(pixel.uvX, pixel.uvY) * turn;
    pixel.uvX = pixel.uv[0] / float(pixel.rays);
    pixel.uvY = pixel.uv[1];
#endif
    return pixel;
}

// Where ray number `ray` of a pixel meets the surface, which is taken to be level within the pixel. The places
// are evenly spaced along the footprint, and across it multiples of the golden ratio, which are so for any
// number of rays.
ReliefSurface reliefPixelSurface(ReliefPixel pixel, int ray) {
    ReliefSurface surface = pixel.surface;
#ifdef RELIEVO_PIXEL_RAYS
    const float golden = 0.618034;
    float step = float(ray) - 0.5 * float(pixel.rays - 1);  // from the middle
    vec2 place = vec2(step / float(pixel.rays), fract(golden * step + 0.5) - 0.5);
    surface.position += pixel.position * place;
    surface.uv += pixel.uv * place;
#endif
    return surface;
}

// The footprint of the pixel for one of its rays: of a level between two as many rays take the coarser one as
// it is nearer to that, and no seam shows where levels change.
ReliefFootprint reliefRayFootprint(ReliefPixel pixel, int ray) {
    ReliefFootprint footprint = pixel.footprint;
    footprint.rounding = (float(ray) + 0.5) / float(pixel.rays);
    return footprint;
}
