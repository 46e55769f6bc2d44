// Access to the maps of a relief. Every lookup of a search goes through here and is counted: the
// count costs nothing where the program does not read it.

uniform sampler2D relievoDepthMap;  // D, linear filter, wrap mode of the map

int reliefFetchCount = 0;

float reliefDepth(vec2 uv) {
    ++reliefFetchCount;
    return textureLod(relievoDepthMap, uv, 0.0).r;
}

// ρ = height/width of the map.
float reliefAspect() {
    ivec2 size = textureSize(relievoDepthMap, 0);
    return float(size.y) / float(size.x);
}
