// What a pixel sees of a surface whose detail is smaller than it: a few normals in place of one, a pair along
// each of two ways in which they vary.

struct ReliefNormals {
    // The mean of the normals, each as long as its facet is larger than the part of the surface below it.
    vec3 upright;
    vec3 first;   // from there to both sides
    vec3 second;  // likewise
    int count;    // 1: the mean stands for all, or 4
};

// Normal number k, from 0, in the same length.
vec3 reliefFacetNormal(ReliefNormals normals, int k) {
    vec3 way = k < 2 ? normals.first : normals.second;
    return normals.upright + (k % 2 == 0 ? way : -way);
}

// The variance of slopes along each axis around a mean of unit normals of that length (Toksvig 2005).
float reliefNormalVariance(float meanLength) {
    return max(1.0 - meanLength, 0.0) / max(meanLength, 1e-3);
}
