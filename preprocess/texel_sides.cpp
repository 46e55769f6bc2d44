#include "preprocess/texel_sides.h"

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
    std::ranges::transform(coverage.texels, inside.begin(), [](float covered) {
        return static_cast<std::uint8_t>(covered >= 0.5f ? 1 : 0);
    });
}

void TexelSides::flipWithin(std::span<const glm::dvec2> loop) {
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
        for (int i = static_cast<int>(std::floor(least.x)); i <= most.x; ++i) {
            if (!isWithin(loop, glm::dvec2(i, j) + 0.5))
                continue;
            const auto row = static_cast<std::size_t>(textures::wrapIndex(j, height, wrap));
            const auto column = static_cast<std::size_t>(textures::wrapIndex(i, width, wrap));
            std::uint8_t& texel = inside[row * static_cast<std::size_t>(width) + column];
            texel = static_cast<std::uint8_t>(1 - texel);
        }
}

}  // namespace relievo::preprocess
