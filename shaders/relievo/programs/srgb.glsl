// Linear RGB to sRGB (IEC 61966-2-1).
vec3 toSrgb(vec3 linear) {
    vec3 low = 12.92 * linear;
    vec3 high = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    return mix(low, high, step(0.0031308, linear));
}
