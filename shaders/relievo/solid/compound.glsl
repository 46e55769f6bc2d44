// Parts joined by union, intersection and difference along a ray: where the ray passes the surface of one, what
// is solid there changes, and the first place that becomes solid is the hit. Between such places nothing is
// looked at, and each part is searched by its own distances.
#include "relievo/solid/parts.glsl"

struct SolidHit {
    vec3 position;  // (u, v, z) of the whole
    float t;        // along the ray
    int outcome;    // RELIEVO_OUTCOME_…
    int steps;      // cells looked at
    int fetches;    // texture lookups
    int part;       // whose surface it is; −1: none
    vec3 place;     // in the part's tile space
    vec3 side;      // outwards from the part, on a side of its window or a level step; else (0,0,0)
    vec2 normal;    // else what the normal has of the outline's direction and of upwards
    bool isTurned;  // the surface is seen from the inside of its part: one that is taken away
};

// Whether what is inside of these parts is solid.
bool solidIsWithin(bool isInside[RELIEVO_SOLID_PARTS]) {
    bool within = isInside[0];
    for (int part = 1; part < RELIEVO_SOLID_PARTS; ++part) {
        int operation = solidParts[part].ways.z;
        if (operation == RELIEVO_SOLID_UNION) {
            within = within || isInside[part];
        } else if (operation == RELIEVO_SOLID_INTERSECTION) {
            within = within && isInside[part];
        } else {
            within = within && !isInside[part];
        }
    }
    return within;
}

SolidHit solidMiss(SolidRay ray, float t, int outcome) {
    return SolidHit(ray.origin + t * ray.direction, t, outcome, solidSteps, reliefFetchCount, -1, vec3(0.0),
                    vec3(0.0), vec2(0.0), false);
}

// Whether the ray passes a surface there; of a ray without numbers nothing is on it.
bool solidIsOnRay(SolidRay ray, float t) { return t < kReliefBoundless && t <= ray.end; }

SolidHit solidHitOf(SolidRay ray, int part, SolidPath path, SolidCursor cursor) {
    return SolidHit(ray.origin + cursor.t * ray.direction, cursor.t, RELIEVO_OUTCOME_HIT, solidSteps,
                    reliefFetchCount, part, solidPoint(path, cursor.t), cursor.side, cursor.normal, false);
}

SolidCursor solidCursorAt(int part, SolidPath path) {
    SolidCursor cursor;
    cursor.t = path.enter;
    cursor.isInside = false;
    cursor.isOnSurface = false;
    cursor.piece = 0;
    cursor.tile = ivec3(0);
    if (solidIsRevolution(part)) {
        cursor.tile = solidTileAt(part, path, path.enter);
    } else {
        cursor.piece = solidFirstPiece(part, path.origin.z + path.enter * path.direction.z,
                                       path.direction.z);
    }
    cursor.side = vec3(0.0);
    cursor.normal = vec2(0.0);
    return cursor;
}

// On to the first place where the ray passes the part's surface. One that meets the window in a point does
// not go in.
void solidFirstCrossing(int part, SolidPath path, inout SolidCursor cursor) {
    if (path.enter < path.leave) {
        solidCross(part, path, cursor);
    } else {
        cursor.t = kReliefBoundless;
    }
}

#if RELIEVO_SOLID_PARTS == 1
SolidHit solidSearch(SolidRay ray) {
    SolidPath path = solidPath(ray, 0);
    SolidCursor cursor = solidCursorAt(0, path);
    solidFirstCrossing(0, path, cursor);
    if (solidIsExhausted) return solidMiss(ray, cursor.t, RELIEVO_OUTCOME_EXHAUSTED);
    if (!solidIsOnRay(ray, cursor.t)) return solidMiss(ray, ray.end, RELIEVO_OUTCOME_MISS);
    return solidHitOf(ray, 0, path, cursor);
}
#else
SolidHit solidSearch(SolidRay ray) {
    SolidPath paths[RELIEVO_SOLID_PARTS];
    SolidCursor cursors[RELIEVO_SOLID_PARTS];
    bool isInside[RELIEVO_SOLID_PARTS];
    for (int part = 0; part < RELIEVO_SOLID_PARTS; ++part) {
        paths[part] = solidPath(ray, part);
        cursors[part] = solidCursorAt(part, paths[part]);
        isInside[part] = false;
        solidFirstCrossing(part, paths[part], cursors[part]);
    }
    // Surfaces that rounding alone keeps apart are passed together.
    float together = 1e-6 * min(ray.end, RELIEVO_MAXIMUM_REACH);
    bool wasWithin = false;
    float t = 0.0;
    while (!solidIsExhausted) {
        t = kReliefBoundless;
        for (int part = 0; part < RELIEVO_SOLID_PARTS; ++part) t = min(t, cursors[part].t);
        if (!solidIsOnRay(ray, t)) return solidMiss(ray, ray.end, RELIEVO_OUTCOME_MISS);
        int passed[RELIEVO_SOLID_PARTS];
        for (int part = 0; part < RELIEVO_SOLID_PARTS; ++part) {
            passed[part] = cursors[part].t <= t + together ? 1 : 0;
            if (passed[part] == 1) isInside[part] = !isInside[part];
        }
        bool within = solidIsWithin(isInside);
        if (within && !wasWithin) {
            // The surface that made it solid: one that was come into, or one that was taken away and left.
            for (int part = RELIEVO_SOLID_PARTS - 1; part >= 0; --part) {
                bool isTaken = part > 0 && solidParts[part].ways.z == RELIEVO_SOLID_DIFFERENCE;
                if (passed[part] == 1 && isInside[part] != isTaken) {
                    SolidHit hit = solidHitOf(ray, part, paths[part], cursors[part]);
                    hit.isTurned = isTaken;
                    return hit;
                }
            }
        }
        wasWithin = within;
        for (int part = 0; part < RELIEVO_SOLID_PARTS; ++part) {
            if (passed[part] == 0) continue;
            cursors[part].isInside = isInside[part];
            if (cursors[part].t >= paths[part].leave) {
                cursors[part].t = kReliefBoundless;
            } else {
                solidCross(part, paths[part], cursors[part]);
            }
        }
    }
    return solidMiss(ray, min(t, ray.end), RELIEVO_OUTCOME_EXHAUSTED);
}
#endif
