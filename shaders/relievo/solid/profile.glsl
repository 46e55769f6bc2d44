// The profile of an extrusion along a ray.
#include "relievo/solid/path.glsl"

int solidPieceIndex(int part, int piece) { return part * RELIEVO_SOLID_MOST_PIECES + piece; }

float solidPieceOffset(int index, float z) {
    vec4 line = solidPieces[index].line;
    return line.z + line.w * (z - line.x);
}

// Whether depth z, on a ray that goes that way, is beyond a piece that is not the last one there.
bool solidIsBeyond(int part, int piece, float z, float dz) {
    vec4 line = solidPieces[solidPieceIndex(part, piece)].line;
    return dz >= 0.0 ? piece < solidParts[part].ways.x - 1 && z >= line.y : piece > 0 && z <= line.x;
}

// The piece at depth z or, going that way, at the next one; never back. The loop is begun only where it has
// something to do: software renderers count its beginnings and end programs that have too many.
int solidPieceAt(int part, int piece, float z, float dz) {
    if (solidIsBeyond(part, piece, z, dz)) {
        int ahead = dz >= 0.0 ? 1 : -1;
        do piece += ahead;
        while (solidIsBeyond(part, piece, z, dz));
    }
    return piece;
}

// The piece where a ray begins.
int solidFirstPiece(int part, float z, float dz) {
    return solidPieceAt(part, dz >= 0.0 ? 0 : solidParts[part].ways.x - 1, z, dz);
}

// What is sure of the distance at a place, in the sense of the ray: that of outside, or its negative inside.
struct SolidSure {
    float steps;
    float beyondCorners;  // where the offset is RELIEVO_SOLID_CORNERS_END at least
};

// How far t can grow for certain before the ray passes the surface, from a place that lies in `piece` at depth z.
float solidFreeOfProfile(int part, int piece, int way, SolidSure sure, float z, float dz, float speed) {
    int index = solidPieceIndex(part, piece);
    float offset = (way < 2 ? 1.0 : -1.0) * solidPieceOffset(index, z);
    float closing = solidPieces[index].chords[way] * abs(dz);
    // Offsets that do not fall stay beyond corners.
    bool isBeyond = offset >= RELIEVO_SOLID_CORNERS_END && closing >= 0.0;
    float gap = (isBeyond ? sure.beyondCorners : sure.steps) - solidParts[part].section.w;
    float everywhere = solidFree(gap - solidPieces[index].extremes[way], 0.0, speed);
    float here = solidFree(gap - offset, closing, speed);
    if (dz != 0.0) here = min(here, max((solidPieces[index].limits[way] - z) / dz, 0.0));
    return kSolidShort * max(everywhere, here);
}

// Where x + y·s + z·s² is 0, in order; kReliefBoundless: nowhere.
vec2 solidZeros(vec3 g) {
    float discriminant = g.y * g.y - 4.0 * g.z * g.x;
    if (discriminant < 0.0 || (g.y == 0.0 && g.z == 0.0)) return vec2(kReliefBoundless);
    // Neither root by a difference in which digits cancel.
    float half_ = -0.5 * (g.y + (g.y < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
    float a = g.z != 0.0 ? half_ / g.z : kReliefBoundless;
    float b = half_ != 0.0 ? g.x / half_ : a;
    return vec2(min(a, b), max(a, b));
}

// The first s in [0, span] at which x + y·s + z·s² passes 0; kReliefBoundless: none. One that begins on the
// surface goes on to where it comes back; where that is level it stays on its side.
float solidFirstRoot(vec3 g, float span, bool isOnSurface, bool isInside) {
    float s = kReliefBoundless;
    if (isOnSurface) {
        if (g.y < 0.0 || (g.y == 0.0 && g.z < 0.0)) return 0.0;
        if (g.z < 0.0) s = -g.y / g.z;
    } else {
        if (solidIsPassed(g.x, isInside)) return 0.0;
        float discriminant = g.y * g.y - 4.0 * g.z * g.x;
        if (discriminant < 0.0) return kReliefBoundless;
        float root = sqrt(discriminant);
        // The smaller positive root in the form in which nothing cancels.
        if (g.y <= 0.0) {
            if (root - g.y > 0.0) s = 2.0 * g.x / (root - g.y);
            if (g.x == 0.0 && g.z < 0.0) s = 0.0;
        } else if (g.z < 0.0) {
            s = (g.y + root) / (-2.0 * g.z);
        }
    }
    return s <= span ? s : kReliefBoundless;
}
