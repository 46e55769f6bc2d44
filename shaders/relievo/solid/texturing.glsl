// Where a picture lies on a solid (thesis 4.6.3): projected along a direction, or from an axis or a centre, on
// each replica anew. Each coordinate comes with its gradient, from which follow the tangents of relief on
// walls, and how much of the picture a pixel covers.
#include "relievo/solid/parts.glsl"

struct SolidTexturing {
    vec2 uv;
    vec3 gradientU;  // ∂/∂(u, v, z) of the part
    vec3 gradientV;
};

const float kSolidTurn = 6.28318531;

// Around an axis at `across`: a whole turn is 1, from −u over −v.
void solidAround(vec2 across, inout SolidTexturing texturing) {
    float square = max(dot(across, across), 1e-12);
    texturing.uv.x = 0.5 - atan(across.y, across.x) / kSolidTurn;
    texturing.gradientU = vec3(across.y, -across.x, 0.0) / (kSolidTurn * square);
}

// `place` in the tile space of a part, `covector` what its surface faces there.
SolidTexturing solidTexturing(int part, vec3 place, vec3 covector) {
    int kind = solidParts[part].ways.w;
    vec3 inTile = place - floor(place);
    // An extrusion ends at z = 1, which is not the beginning of another.
    if (!solidIsRevolution(part)) inTile.z = place.z;
    vec3 facing = abs(covector);
    if (kind == RELIEVO_TEXTURING_BOX && facing.z < max(facing.x, facing.y)) {
        SolidTexturing wall = SolidTexturing(inTile.yz, vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0));
        if (facing.y > facing.x) {
            wall.uv.x = inTile.x;
            wall.gradientU = vec3(1.0, 0.0, 0.0);
        }
        return wall;
    }
    if (kind == RELIEVO_TEXTURING_PLANAR_Z || kind == RELIEVO_TEXTURING_BOX)
        return SolidTexturing(inTile.xy, vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
    SolidTexturing result =
        SolidTexturing(vec2(inTile.x, inTile.z), vec3(1.0, 0.0, 0.0), vec3(0.0, 0.0, 1.0));
    vec2 across = inTile.xy - solidParts[part].section.xy;
    if (kind == RELIEVO_TEXTURING_PLANAR_DIAGONAL) {
        result.uv.x = 0.5 * (inTile.x + inTile.y);
        result.gradientU = vec3(0.5, 0.5, 0.0);
    }
    if (kind >= RELIEVO_TEXTURING_CYLINDRICAL) solidAround(across, result);
    if (kind == RELIEVO_TEXTURING_SPHERICAL) {
        vec3 out3 = vec3(across, inTile.z - 0.5);
        float radius = max(length(out3), 1e-6);
        float wide = max(length(across), 1e-6);
        // The arc cosine of z/radius, which is exact near the poles as well.
        result.uv.y = 1.0 - atan(wide, out3.z) / (0.5 * kSolidTurn);
        result.gradientV =
            vec3(-out3.z * across / wide, wide) / (radius * radius * 0.5 * kSolidTurn);
    }
    return result;
}
