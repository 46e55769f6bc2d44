// Several rays in a pixel, side by side along the longer side of what it covers: where the view grazes
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
    vec3 positionAlong;  // from one end of the footprint to the other
    vec2 uvAlong;
};

// The pixel around a point of a surface. To be called where neighbouring pixels come by too.
ReliefPixel reliefPixel(ReliefSurface surface, float aspect) {
    ReliefPixel pixel;
    pixel.surface = surface;
    pixel.footprint = reliefFootprint(surface.uv, aspect);
    pixel.rays = 1;
    pixel.uvX = dFdx(surface.uv);
    pixel.uvY = dFdy(surface.uv);
    pixel.positionAlong = vec3(0.0);
    pixel.uvAlong = vec2(0.0);
#ifdef RELIEVO_PIXEL_RAYS
    // No more rays than parts as long as the footprint is wide; infinite where it has no width.
    float parts = pixel.footprint.longest / max(pixel.footprint.shortest, 1e-30);
    pixel.rays = int(ceil(clamp(parts, 1.0, float(relievoPixelRays))));
    vec2 along = reliefLongestDirection(surface.uv, aspect);
    pixel.positionAlong = along.x * dFdx(surface.position) + along.y * dFdy(surface.position);
    pixel.uvAlong = along.x * pixel.uvX + along.y * pixel.uvY;
    vec2 uvAcross = along.x * pixel.uvY - along.y * pixel.uvX;
    pixel.uvX = pixel.uvAlong / float(pixel.rays);
    pixel.uvY = uvAcross;
#endif
    return pixel;
}

// Where ray number `ray` of a pixel meets the surface, which is taken to be level within the pixel.
ReliefSurface reliefPixelSurface(ReliefPixel pixel, int ray) {
    ReliefSurface surface = pixel.surface;
#ifdef RELIEVO_PIXEL_RAYS
    float place = (float(ray) + 0.5) / float(pixel.rays) - 0.5;
    surface.position += place * pixel.positionAlong;
    surface.uv += place * pixel.uvAlong;
#endif
    return surface;
}
