// A ray in the space of a whole solid, and what each part sees of it.
#include "relievo/solid/block.glsl"
#include "relievo/ray.glsl"

struct SolidRay {
    vec3 origin;     // (u, v, z) of the whole
    vec3 direction;  // per unit of t, of any length
    float end;       // t at which the ray ends, ≥ 0
};

// A ray in the tile space of a part.
struct SolidPath {
    vec3 origin;
    vec3 direction;
    float enter;        // t at which it comes into the part's window, ≥ 0, and leaves it;
    float leave;        // it never comes in when it would leave before
    vec3 enterNormal;   // outwards from the sides of the window that it passes there
    vec3 leaveNormal;
};

// The part's far and near ends along one axis: narrows the path to low ≤ place ≤ high.
void solidNarrow(inout SolidPath path, int axis, float low, float high) {
    float origin = path.origin[axis];
    float direction = path.direction[axis];
    vec3 side = vec3(0.0);
    side[axis] = direction > 0.0 ? -1.0 : 1.0;
    if (direction == 0.0) {
        if (origin < low || origin > high) path.leave = -1.0;
        return;
    }
    float near = ((direction > 0.0 ? low : high) - origin) / direction;
    float far = ((direction > 0.0 ? high : low) - origin) / direction;
    if (near >= path.enter) {
        path.enter = near;
        path.enterNormal = side;
    }
    if (far < path.leave) {
        path.leave = far;
        path.leaveNormal = -side;
    }
}

// The ray as a part sees it. One that begins inside of the window comes in by no side of it, one that begins
// on its border by that.
SolidPath solidPath(SolidRay ray, int part) {
    SolidPart info = solidParts[part];
    SolidPath path;
    path.origin = (info.fromWhole * vec4(ray.origin, 1.0)).xyz;
    path.direction = mat3(info.fromWhole) * ray.direction;
    path.enter = 0.0;
    path.leave = ray.end;
    path.enterNormal = vec3(0.0);
    path.leaveNormal = vec3(0.0);
    for (int axis = 0; axis < 3; ++axis)
        solidNarrow(path, axis, info.windowMinimum[axis], info.windowMaximum[axis]);
    return path;
}

vec3 solidPoint(SolidPath path, float t) { return path.origin + t * path.direction; }

// Where the search for the surface of a part has come to.
struct SolidCursor {
    float t;           // of the next place where the ray passes the surface; kReliefBoundless: none
    bool isInside;     // before it
    bool isOnSurface;  // a search from there begins on the surface itself
    int piece;         // of the profile
    ivec3 tile;        // the replica of a revolution
    vec3 side;         // outwards, where the surface is a side of the window or level: (0,0,0) elsewhere
    vec2 normal;       // elsewhere: what the normal has of the outline's direction and of upwards
};

// Which way a ray looks at a profile: down or up from outside, down or up from inside.
int solidWay(float dz, bool isInside) { return (dz < 0.0 ? 1 : 0) + (isInside ? 2 : 0); }
int solidWayBack(int way) { return way ^ 1; }  // of a ray that runs backwards

// Whether the surface has been passed where the function of the solid has this value in the sense of the ray.
// The surface itself is solid, and so is all of a map without signs that is 0: what is inside stays so.
bool solidIsPassed(float value, bool isInside) { return isInside ? value < 0.0 : value <= 0.0; }

// The t until which a ray is free that is `gap` texels in front of a surface, goes `speed` texels a unit of t
// and is approached by it at `closing` (< 0: it retreats). The bilinear interpolation of distances is their mean over
// places rounded at random to the corners of the cell; from a place to one r texels on they are rounded by
// a variance of ½ in all, and so it falls by at most √(r² + ½); and along each axis by r, so by √2·r.
// A surface that retreats as fast as the ray goes is never reached; where it nearly does, digits cancel, and what
// they are off by is taken off.
float solidFree(float gap, float closing, float speed) {
    if (gap <= 0.0) return 0.0;
    float straight = gap / max(1.41421356 * speed + closing, 1e-30);
    float squares = gap * gap - 0.5;
    if (squares <= 0.0) return straight;
    float root = sqrt(speed * speed * squares + 0.5 * closing * closing);
    return max(straight, squares / max(gap * closing + root * (1.0 + 5e-7), 1e-30));
}

// Rounding of a few operations must not make a step too long.
const float kSolidShort = 1.0 - 1e-5;
