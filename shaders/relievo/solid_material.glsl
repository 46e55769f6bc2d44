// What a solid looks like where a ray has hit it: where its picture lies, how much of that a pixel covers.
#include "relievo/solid_trace.glsl"
#include "relievo/solid/texturing.glsl"

uniform vec2 relievoSolidPictureTiles;  // of pictures and of a relief, in a tile of the texturing

struct SolidSurface {
    vec3 color;     // of the part, linear RGB
    vec2 uv;        // of its picture
    vec2 uvX;       // how these change from pixel to pixel
    vec2 uvY;
    vec3 gradientU;  // of u and v of the picture, in world space
    vec3 gradientV;
};

// How far the place of a hit moves when the place and the direction of its ray do, on the plane of its
// surface.
vec3 solidMove(SolidTrace trace, vec3 view, vec3 place, vec3 turn) {
    vec3 move = place + trace.hit.t * turn;
    float facing = dot(trace.normal, view);
    // Where the surface is seen from its edge a pixel covers no end of it.
    return move - view * (dot(trace.normal, move) / (abs(facing) > 0.01 ? facing : -0.01));
}

// `placeX` and the like are ∂(start of the ray, its direction)/∂(x, y) on the screen.
SolidSurface solidSurface(SolidTrace trace, vec3 view, vec3 placeX, vec3 placeY, vec3 turnX, vec3 turnY) {
    int part = trace.hit.part;
    mat3 toPart = mat3(solidParts[part].fromWhole) * trace.toWhole;
    // The normal's covector in the part: what it says of directions there.
    vec3 covector = trace.normal * inverse(toPart);
    SolidTexturing texturing = solidTexturing(part, trace.hit.place, covector);
    SolidSurface result;
    result.color = solidParts[part].color.rgb;
    result.uv = relievoSolidPictureTiles * texturing.uv;
    result.gradientU = relievoSolidPictureTiles.x * texturing.gradientU * toPart;
    result.gradientV = relievoSolidPictureTiles.y * texturing.gradientV * toPart;
    vec3 moveX = solidMove(trace, view, placeX, turnX);
    vec3 moveY = solidMove(trace, view, placeY, turnY);
    result.uvX = vec2(dot(result.gradientU, moveX), dot(result.gradientV, moveX));
    result.uvY = vec2(dot(result.gradientU, moveY), dot(result.gradientV, moveY));
    return result;
}
