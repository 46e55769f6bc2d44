#include "preprocess/texel_sides.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace relievo::preprocess {
namespace {

bool isWithin(std::span<const glm::dvec2> loop, const glm::dvec2& place) {
    bool inside = false;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const glm::dvec2& a = loop[k];
        const glm::dvec2& b = loop[(k + 1) % loop.size()];
        if ((a.y <= place.y) != (b.y <= place.y) &&
            place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

}  // namespace

TexelSides::TexelSides(const textures::Plane& coverage, textures::WrapMode wrap_)
    : width(coverage.width), height(coverage.height), wrap(wrap_), inside(coverage.texels.size()) {
    constexpr std::size_t kTexelsAtOnce = 1 << 16;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, inside.size(), kTexelsAtOnce),
                      [&](const tbb::blocked_range<std::size_t>& texels) {
                          for (std::size_t t = texels.begin(); t < texels.end(); ++t)
                              inside[t] = coverage.texels[t] >= 0.5f ? 1 : 0;
                      });
}

void TexelSides::appendWithin(std::span<const glm::dvec2> loop,
                              std::vector<std::size_t>& texels) const {
    glm::dvec2 least = loop.front();
    glm::dvec2 most = loop.front();
    for (const glm::dvec2& place : loop) {
        least = glm::min(least, place);
        most = glm::max(most, place);
    }
    if (wrap != textures::WrapMode::Repeat) {
        least = glm::max(least, glm::dvec2(0.0));
        most = glm::min(most, glm::dvec2(width, height) - 0.5);
    }
    for (int j = static_cast<int>(std::floor(least.y)); j <= most.y; ++j)
        for (int i = static_cast<int>(std::floor(least.x)); i <= most.x; ++i)
            if (isWithin(loop, glm::dvec2(i, j) + 0.5))
                texels.push_back(index(i, j));
}

void TexelSides::flip(std::span<const std::size_t> texels) {
    for (const std::size_t texel : texels)
        inside[texel] = static_cast<std::uint8_t>(1 - inside[texel]);
}

}  // namespace relievo::preprocess
