// Light from all around, where a renderer has no picture of the surroundings: a sky above and a ground below,
// each of one colour (hemisphere lighting). World space has z up.

// What arrives from around a direction of unit length, averaged over a lobe. A width of 1 is the cosine lobe
// of a diffuse surface, which sees the share (1 + z)/2 of the sky exactly; towards 0 the horizon gets sharp.
// `width` is above 0. Returns linear RGB.
vec3 reliefSurroundings(vec3 direction, float width) {
    const vec3 sky = vec3(0.20, 0.215, 0.245);
    const vec3 ground = vec3(0.12, 0.115, 0.11);
    return mix(ground, sky, 0.5 + 0.5 * clamp(direction.z / width, -1.0, 1.0));
}
