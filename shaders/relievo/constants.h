// Constants that C++ and GLSL share: this file is included by both.
#ifndef RELIEVO_CONSTANTS_H
#define RELIEVO_CONSTANTS_H

// Vertex attributes of a surface that carries a relief.
#define RELIEVO_ATTRIBUTE_POSITION 0
#define RELIEVO_ATTRIBUTE_NORMAL 1
#define RELIEVO_ATTRIBUTE_TANGENT 2
#define RELIEVO_ATTRIBUTE_BITANGENT 3
#define RELIEVO_ATTRIBUTE_UV 4

// Colour attachments of programs/measured.frag, all RGBA32F.
#define RELIEVO_OUTPUT_HIT 0     // (u, v, z) of the hit, t along the ray
#define RELIEVO_OUTPUT_WORK 1    // outcome, steps, fetches, 1 where a fragment was drawn
#define RELIEVO_OUTPUT_ORIGIN 2  // (u, v, z) where the ray enters the relief, t where it leaves it
#define RELIEVO_OUTPUT_DIRECTION 3  // (du, dv, dz) of the ray, world length of one unit of t
#define RELIEVO_OUTPUT_NORMAL 4     // unit shading normal in the tile's metric, z up
// Of the light at the hit (light.glsl): the direction towards it and the share of it that gets
// there; the edges of its disc, and the lookups that the shadow took.
#define RELIEVO_OUTPUT_LIGHT 5  // (du, dv, dz), share
#define RELIEVO_OUTPUT_LIFT 6   // (du, dv, dz), fetches
#define RELIEVO_OUTPUT_SIDE 7   // (du, dv, dz)
#define RELIEVO_OUTPUT_COUNT 8

// Colour attachments of programs/visible.frag, both RGBA32F.
#define RELIEVO_VISIBLE_POINT 0  // world position, number of the object + 1
#define RELIEVO_VISIBLE_LIGHT 1  // 1 in the light, 0 in shadow

// Shader storage buffers.
#define RELIEVO_BUFFER_LOOKUPS 0  // two unsigned integers: lookups of a frame, the lower half first

// Of solids: block.glsl.
#define RELIEVO_BLOCK_SOLID 0  // uniform buffer
#define RELIEVO_SOLID_MOST_PARTS 4
#define RELIEVO_SOLID_MOST_PIECES 32  // of the profile of a part
#define RELIEVO_SOLID_EXTRUSION 0
#define RELIEVO_SOLID_REVOLUTION 1
#define RELIEVO_SOLID_REPEAT 0
#define RELIEVO_SOLID_MIRROR 1
#define RELIEVO_SOLID_CLAMP 2
#define RELIEVO_SOLID_UNION 0
#define RELIEVO_SOLID_INTERSECTION 1
#define RELIEVO_SOLID_DIFFERENCE 2
// What the code of a reflex crease has more than that of a convex one, in texels.
#define RELIEVO_SOLID_CREASE 16.0
#define RELIEVO_SOLID_LEAST_REFLEX 12.0
// From this offset on, in texels, steps go by distances around corners as well.
#define RELIEVO_SOLID_CORNERS_END 4.0
// The last bits of a distance whose last one is set: the texel is lowered for steps, perhaps has a
// crease, and for steps is lowered by so many units of which the deepest are the depth of the map's
// creases.
#define RELIEVO_SOLID_MARK_BITS 127u
#define RELIEVO_SOLID_MARK_LOWERED 1u
#define RELIEVO_SOLID_MARK_CREASED 2u
#define RELIEVO_SOLID_MARK_UNIT 4u
#define RELIEVO_SOLID_MARK_DEEPEST 31u

// How pictures are put on a solid: texturing.glsl.
#define RELIEVO_TEXTURING_PLANAR_Z 0         // along z: (u, v)
#define RELIEVO_TEXTURING_PLANAR_Y 1         // along v: (u, z)
#define RELIEVO_TEXTURING_PLANAR_DIAGONAL 2  // along u − v: ((u + v)/2, z)
#define RELIEVO_TEXTURING_CYLINDRICAL 3
#define RELIEVO_TEXTURING_SPHERICAL 4
#define RELIEVO_TEXTURING_BOX 5  // along the axis that the surface faces most

// How a search ended.
#define RELIEVO_OUTCOME_HIT 0        // at the first point found in the solid
#define RELIEVO_OUTCOME_MISS 1       // the ray left the relief's window above the surface
#define RELIEVO_OUTCOME_EXHAUSTED 2  // the steps ran out: position is the last point reached

// The longest search, in tile widths of horizontal distance, on a relief without a window. Only
// rays that are nearly level come near it.
#define RELIEVO_MAXIMUM_REACH 1000.0

#endif
