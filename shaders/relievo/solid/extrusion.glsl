// Where a ray passes the surface of an extrusion d(u,v) = o(z) (specification 7.2), d bilinear between texel
// centres and o straight from piece to piece: cells are solved exactly, one quadratic a piece, and from where
// the ray leaves a cell it goes on as far as the distance there says that all is free, and farther where that
// can be made good. No step can pass the surface, whatever its slope, and no second search is needed.
//
// Error: rounding of floats. Cost: one lookup a cell, at a crease one more where the ray may pass the surface;
// and one a leap that was too long.
#include "relievo/search/walk.glsl"
#include "relievo/solid/cell.glsl"
#include "relievo/solid/leap.glsl"
#include "relievo/solid/profile.glsl"

// Puts the cursor on a wall of a piece, or on the level step that the ray has come to.
void solidMeetWall(int index, float z, float t, inout SolidCursor cursor) {
    SolidPiece piece = solidPieces[index];
    float share = clamp((z - piece.line.x) / (piece.line.y - piece.line.x), 0.0, 1.0);
    cursor.t = t;
    cursor.side = vec3(0.0);
    cursor.normal = mix(piece.normals.xy, piece.normals.zw, share);
    cursor.isOnSurface = true;
}

void solidMeetStep(float t, float dz, inout SolidCursor cursor) {
    cursor.t = t;
    cursor.side = vec3(0.0, 0.0, (dz > 0.0) != cursor.isInside ? -1.0 : 1.0);
    cursor.isOnSurface = false;
}

// Looks for the surface on the part of the walk's cell between `from` and `exit`. `distances` are those of
// reliefAlongCell in the sense of the ray. False: the cursor's piece is that at the exit.
bool solidMeetField(int part, SolidPath path, ReliefWalk walk, vec3 distances, float from, float exit,
                    bool isOnSurface, inout SolidCursor cursor) {
    float sense = cursor.isInside ? -1.0 : 1.0;
    float dz = path.direction.z;
    bool isStep = false;
    for (int pieces = solidParts[part].ways.x; pieces > 0; --pieces) {
        int index = solidPieceIndex(part, cursor.piece);
        vec4 line = solidPieces[index].line;
        float z = path.origin.z + from * dz;
        float leave = kReliefBoundless;
        if (dz != 0.0) leave = ((dz > 0.0 ? line.y : line.x) - path.origin.z) / dz;
        float to = min(max(leave, from), exit);
        float s = from - walk.t;
        vec3 g = vec3(distances.x + (distances.y + distances.z * s) * s - sense * solidPieceOffset(index, z),
                      distances.y + 2.0 * distances.z * s - sense * line.w * dz, distances.z);
        float root = solidFirstRoot(g, to - from, isOnSurface, cursor.isInside);
        if (root < kReliefBoundless) {
            float t = from + root;
            if (isStep && root == 0.0) {
                solidMeetStep(t, dz, cursor);
            } else {
                solidMeetWall(index, path.origin.z + t * dz, t, cursor);
            }
            return true;
        }
        if (leave >= exit) return false;
        int next = cursor.piece + (dz > 0.0 ? 1 : -1);
        if (next < 0 || next >= solidParts[part].ways.x) return false;
        float border = dz > 0.0 ? line.y : line.x;
        int nextIndex = solidPieceIndex(part, next);
        // Where the offsets agree the next piece begins with a wall, whatever rounding says.
        float rise = sense * (solidPieceOffset(nextIndex, border) - solidPieceOffset(index, border));
        isStep = rise > 1e-3;
        cursor.piece = next;
        from = to;
        isOnSurface = false;
    }
    return false;
}

#ifdef RELIEVO_SOLID_CREASED
// The same up to `exit` with creases, where the distance goes over from one field to the other. Steps are below
// the distance: where they do not come to the surface from outside it does not either.
bool solidMeetInCell(sampler2D map, int part, SolidPath path, ReliefWalk walk, SolidSamples samples,
                     float exit, bool isOnSurface, inout SolidCursor cursor) {
    float sense = cursor.isInside ? -1.0 : 1.0;
    if (samples.isCreased && !cursor.isInside && !isOnSurface) {
        SolidCursor ahead = cursor;
        vec3 steps = reliefAlongCell(walk, samples.steps);
        if (!solidMeetField(part, path, walk, steps, walk.t, exit, false, ahead)) {
            cursor = ahead;
            return false;
        }
    }
    SolidCell cell = solidCell(map, reliefWalkGather(walk), samples);
    vec3 first = reliefAlongCell(walk, cell.first);
    vec3 second = reliefAlongCell(walk, cell.second);
    vec3 apart = first - second;
    vec2 creases = walk.t + solidZeros(apart);
    float from = walk.t;
    for (int k = 0; k < 3; ++k) {
        float to = k == 0 ? creases.x : (k == 1 ? creases.y : exit);
        to = min(to, exit);
        if (to < from || (to == from && k < 2)) continue;
        float s = 0.5 * (from + to) - walk.t;
        bool isFirst = solidIsFirst(cell, apart.x + (apart.y + apart.z * s) * s, 0.0);
        if (solidMeetField(part, path, walk, sense * (isFirst ? first : second), from, to, isOnSurface, cursor))
            return true;
        from = to;
        isOnSurface = false;
    }
    return false;
}
#else
bool solidMeetInCell(sampler2D map, int part, SolidPath path, ReliefWalk walk, SolidSamples samples,
                     float exit, bool isOnSurface, inout SolidCursor cursor) {
    float sense = cursor.isInside ? -1.0 : 1.0;
    return solidMeetField(part, path, walk, sense * reliefAlongCell(walk, samples.distances), walk.t, exit,
                          isOnSurface, cursor);
}
#endif

// Whether the surface has been passed where the walk's ray enters its cell: `gap` is sure of the distance less
// the offset, both in the sense of the ray.
bool solidHasPassed(sampler2D map, int part, ReliefWalk walk, SolidSamples samples, float gap, float offset,
                    bool isInside) {
    if (!solidIsPassed(gap, isInside)) return false;
    if (solidIsPassed(gap + solidCreaseDepth(part), isInside)) return true;
    SolidCell cell = solidCell(map, reliefWalkGather(walk), samples);
    float first = reliefAlongCell(walk, cell.first).x;
    float second = reliefAlongCell(walk, cell.second).x;
    float distance = solidIsFirst(cell, first, second) ? first : second;
    return solidIsPassed((isInside ? -distance : distance) - offset, isInside);
}

// What is sure of the distance in the walk's cell, as reliefAlongCell has it, in the sense of the ray.
struct SolidSureCell {
    vec3 steps;
    vec3 beyondCorners;
};

SolidSureCell solidSureCell(int part, ReliefWalk walk, SolidSamples samples, bool isInside) {
    vec3 steps = reliefAlongCell(walk, samples.steps);
    if (!isInside) return SolidSureCell(steps, reliefAlongCell(walk, samples.distances));
    steps = -steps - vec3(solidCreaseDepth(part), 0.0, 0.0);
    return SolidSureCell(steps, steps);
}

float solidAlong(vec3 terms, float s) { return terms.x + (terms.y + terms.z * s) * s; }

SolidSure solidSureAt(SolidSureCell cell, float s) {
    return SolidSure(solidAlong(cell.steps, s), solidAlong(cell.beyondCorners, s));
}

// On to t where that is beyond the walk's cell.
void solidReachWalk(inout ReliefWalk walk, float t) {
    if (t > walk.exit) reliefJumpWalk(walk, t);
}

// What is ahead at depth z, where the distance has that slope along the ray and `free` of t is free.
SolidOutlook solidOutlook(int index, float sense, float distance, float slope, float free, float z,
                          float dz, float speed) {
    float gap = distance - sense * solidPieceOffset(index, z);
    return SolidOutlook(gap, free * speed, -slope / speed, sense * solidPieces[index].line.w * dz / speed);
}

// On to the next place where the ray passes the surface, from the cursor's.
void solidCrossExtrusion(sampler2D map, int part, SolidPath path, inout SolidCursor cursor) {
    ReliefWalk walk = reliefBeginWalk(path.origin.xy, path.direction.xy, textureSize(map, 0),
                                      solidIsClamped(part));
    if (cursor.t > 0.0) reliefJumpWalk(walk, cursor.t);
    float sense = cursor.isInside ? -1.0 : 1.0;
    float dz = path.direction.z;
    float speed = length(walk.speed);
    int way = solidWay(dz, cursor.isInside);
    bool isStart = true;
    bool isOnSurface = cursor.isOnSurface;
    SolidLeap leap = solidBeginLeaps(walk.t);
    ReliefWalk back = walk;  // from where to go on after a leap that was too long
    int backPiece = cursor.piece;
    while (solidSteps < relievoSolidSteps) {
        ++solidSteps;
        SolidSamples samples = solidLookUp(map, part, reliefWalkGather(walk));
        SolidSureCell sure = solidSureCell(part, walk, samples, cursor.isInside);
        float exit = min(walk.exit, path.leave);
        float z = path.origin.z + walk.t * dz;
        if (!isStart) cursor.piece = solidPieceAt(part, cursor.piece, z, dz);
        float clear = walk.t;
        if (!isOnSurface) {
            float offset = sense * solidPieceOffset(solidPieceIndex(part, cursor.piece), z);
            if (isStart &&
                solidHasPassed(map, part, walk, samples, sure.steps.x - offset, offset, cursor.isInside)) {
                // What is solid where a ray begins shows the side that it came in by.
                cursor.side = path.enterNormal;
                return;
            }
            SolidSure here = solidSureAt(sure, 0.0);
            float ahead = solidFreeOfProfile(part, cursor.piece, way, here, z, dz, speed);
            float behind = solidFreeOfProfile(part, cursor.piece, solidWayBack(way), here, z, -dz, speed);
            if (!solidHasLanded(leap, walk.t, behind, ahead)) {
                walk = back;
                solidReachWalk(walk, leap.clear);
                cursor.piece = backPiece;
                continue;
            }
            clear += ahead;
        }
        // A cell of no length leads neither off the surface nor through it.
        bool isBare = isOnSurface && exit <= cursor.t;
        if (clear <= exit && !isBare &&
            solidMeetInCell(map, part, path, walk, samples, exit, isOnSurface, cursor))
            return;
        z = path.origin.z + exit * dz;
        cursor.piece = solidPieceAt(part, cursor.piece, z, dz);
        float span = exit - walk.t;
        SolidSure there = solidSureAt(sure, span);
        float free = solidFreeOfProfile(part, cursor.piece, way, there, z, dz, speed);
        clear = solidClearOfIsland(leap, max(clear, exit + free));
        if (clear >= path.leave) {
            cursor.t = cursor.isInside ? path.leave : kReliefBoundless;
            cursor.side = path.leaveNormal;
            cursor.isOnSurface = false;
            return;
        }
        isStart = false;
        isOnSurface = isBare;
        // The step alone is sure to leave the cell.
        reliefStepWalk(walk);
        back = walk;
        backPiece = cursor.piece;
        leap.clear = max(clear, walk.t);
        SolidOutlook outlook =
            solidOutlook(solidPieceIndex(part, backPiece), sense, there.steps,
                         sure.steps.y + 2.0 * sure.steps.z * span, isOnSurface ? 0.0 : free, z, dz, speed);
        solidReachWalk(walk, solidLeap(leap, outlook, speed, float(walk.size.x), path.leave));
    }
    cursor.t = min(walk.t, leap.clear);
    solidIsExhausted = true;
}
