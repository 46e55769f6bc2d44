#include "preprocess/cone_encoding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "preprocess/round_down.h"

namespace relievo::preprocess {
namespace {

constexpr float kUnlimited = std::numeric_limits<float>::infinity();

float radiusOf(float ratio, float depth) {
    if (std::isinf(ratio))
        return kUnlimited;  // also over depth 0, where the product is not a number
    return roundDown(belowRounding(static_cast<double>(ratio) * depth));
}

float ratioOf(float radius, float depth) {
    if (depth == 0.0f || std::isinf(radius))
        return kUnlimited;
    return roundDown(belowRounding(static_cast<double>(radius) / depth));
}

void transform(textures::Plane& cone, const textures::Plane& depth,
               float (*function)(float, float)) {
    assert(cone.width == depth.width && cone.height == depth.height);
    std::transform(cone.texels.begin(), cone.texels.end(), depth.texels.begin(),
                   cone.texels.begin(), function);
}

}  // namespace

void encodeConesInPlace(textures::Plane& cone, const textures::Plane& depth,
                        textures::ConeEncoding encoding) {
    if (encoding == textures::ConeEncoding::Radius)
        transform(cone, depth, radiusOf);
}

textures::Plane encodeCones(const textures::Plane& ratio, const textures::Plane& depth,
                            textures::ConeEncoding encoding) {
    textures::Plane cone = ratio;
    encodeConesInPlace(cone, depth, encoding);
    return cone;
}

textures::Plane decodeCones(const textures::Plane& cone, const textures::Plane& depth,
                            textures::ConeEncoding encoding) {
    textures::Plane ratio = cone;
    if (encoding == textures::ConeEncoding::Radius)
        transform(ratio, depth, ratioOf);
    return ratio;
}

}  // namespace relievo::preprocess
