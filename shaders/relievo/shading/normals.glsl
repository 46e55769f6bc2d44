// What a pixel sees of a surface whose detail is smaller than it: a few normals in place of one.

struct ReliefNormals {
    vec3 directions[4];  // of unit length
    float shares[4];     // of what is seen; they add up to 1
    int count;           // 1 or 4; those beyond mean nothing
};

ReliefNormals reliefSingleNormal(vec3 normal) {
    return ReliefNormals(vec3[4](normal, normal, normal, normal), float[4](1.0, 0.0, 0.0, 0.0), 1);
}

// Their mean; it is the shorter the more they differ.
vec3 reliefMeanNormal(ReliefNormals normals) {
    vec3 mean = vec3(0.0);
    for (int k = 0; k < normals.count; ++k) mean += normals.shares[k] * normals.directions[k];
    return mean;
}

// The variance of slopes along each axis around a mean normal of that length (Toksvig 2005).
float reliefNormalVariance(float meanLength) {
    return max(1.0 - meanLength, 0.0) / max(meanLength, 1e-3);
}
