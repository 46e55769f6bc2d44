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

// The distance in the walk's cell as reliefAlongCell has it, in the sense of the ray: that of one field or, from
// crease to crease (t), of another one.
struct SolidAlong {
    vec3 first;
#ifdef RELIEVO_SOLID_CREASED
    vec3 second;
    vec2 creases;
    bool isLarger;
#endif
};

float solidAlong(vec3 terms, float s) { return terms.x + (terms.y + terms.z * s) * s; }

SolidAlong solidAlongCell(ReliefWalk walk, SolidCell cell, float sense) {
    vec3 first = sense * reliefAlongCell(walk, cell.first);
#ifdef RELIEVO_SOLID_CREASED
    vec3 second = sense * reliefAlongCell(walk, cell.second);
    return SolidAlong(first, second, walk.t + solidZeros(first - second), cell.isLarger == (sense > 0.0));
#else
    return SolidAlong(first);
#endif
}

// The field that is the distance from `from` on, and up to what t before `to`.
vec3 solidFieldFrom(SolidAlong along, ReliefWalk walk, float from, inout float to) {
#ifdef RELIEVO_SOLID_CREASED
    if (from < along.creases.y) to = min(to, from < along.creases.x ? along.creases.x : along.creases.y);
    float apart = solidAlong(along.first - along.second, 0.5 * (from + to) - walk.t);
    if ((apart > 0.0) != along.isLarger) return along.second;
#endif
    return along.first;
}

// The difference of a field and the offset of a piece along the ray from `from` on, as reliefAlongCell has it.
vec3 solidGapAlong(SolidPath path, ReliefWalk walk, vec3 distances, int index, float from, float sense) {
    float s = from - walk.t;
    float dz = path.direction.z;
    float offset = solidPieceOffset(index, path.origin.z + from * dz);
    return vec3(solidAlong(distances, s) - sense * offset,
                distances.y + 2.0 * distances.z * s - sense * solidPieces[index].line.w * dz, distances.z);
}

// The t at which the ray leaves a piece's depths.
float solidPieceExit(SolidPath path, vec4 line) {
    float dz = path.direction.z;
    return dz != 0.0 ? ((dz > 0.0 ? line.y : line.x) - path.origin.z) / dz : kReliefBoundless;
}

// Looks for the surface in the walk's cell up to `exit`. False: the cursor's piece is that at the exit.
bool solidMeetField(int part, SolidPath path, ReliefWalk walk, SolidAlong along, float exit, bool isOnSurface,
                    inout SolidCursor cursor) {
    float sense = cursor.isInside ? -1.0 : 1.0;
    float dz = path.direction.z;
    float from = walk.t;
    bool isStep = false;
    for (int stretches = solidParts[part].ways.x + 2; stretches > 0; --stretches) {
        int index = solidPieceIndex(part, cursor.piece);
        vec4 line = solidPieces[index].line;
        float leave = solidPieceExit(path, line);
        float end = min(max(leave, from), exit);
        float to = end;
        vec3 distances = solidFieldFrom(along, walk, from, to);
        vec3 g = solidGapAlong(path, walk, distances, index, from, sense);
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
        from = to;
        isOnSurface = false;
        isStep = false;
        if (to < end) continue;
        if (leave >= exit) return false;
        int next = cursor.piece + (dz > 0.0 ? 1 : -1);
        if (next < 0 || next >= solidParts[part].ways.x) return false;
        float border = dz > 0.0 ? line.y : line.x;
        int nextIndex = solidPieceIndex(part, next);
        // Where the offsets agree the next piece begins with a wall, whatever rounding says.
        isStep = sense * (solidPieceOffset(nextIndex, border) - solidPieceOffset(index, border)) > 1e-3;
        cursor.piece = next;
    }
    return false;
}

// The same for what one lookup says of the cell. Steps are below the distance: where within a piece they do not come
// to the surface from outside the distance does not either, and no crease is looked up.
bool solidMeetInCell(sampler2D map, int part, SolidPath path, ReliefWalk walk, SolidSamples samples,
                     float exit, bool isOnSurface, inout SolidCursor cursor) {
    float sense = cursor.isInside ? -1.0 : 1.0;
#ifdef RELIEVO_SOLID_CREASED
    if (samples.isCreased && !cursor.isInside && !isOnSurface) {
        int index = solidPieceIndex(part, cursor.piece);
        vec3 g = solidGapAlong(path, walk, reliefAlongCell(walk, samples.steps), index, walk.t, 1.0);
        if (solidPieceExit(path, solidPieces[index].line) >= exit &&
            solidFirstRoot(g, exit - walk.t, false, false) >= kReliefBoundless)
            return false;
    }
#endif
    SolidCell cell = solidCell(map, reliefWalkGather(walk), samples);
    return solidMeetField(part, path, walk, solidAlongCell(walk, cell, sense), exit, isOnSurface, cursor);
}

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
