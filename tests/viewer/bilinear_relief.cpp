#include "bilinear_relief.h"

#include <array>
#include <glm/geometric.hpp>

namespace relievo::viewer {

double bilinearDepth(glm::dvec2 uv) {
    return 0.2 + 0.3 * uv.x + 0.2 * uv.y + 0.25 * uv.x * uv.y;
}

glm::dvec2 bilinearSlope(glm::dvec2 uv) {
    return {0.3 + 0.25 * uv.y, 0.2 + 0.25 * uv.x};
}

glm::dvec3 bilinearNormalAt(glm::dvec2 uv, double aspect, double depthScale) {
    const glm::dvec2 gradient = bilinearSlope(uv) / glm::dvec2(1.0, aspect);
    return glm::normalize(glm::dvec3(depthScale * gradient, 1.0));
}

textures::MapSet bilinearMaps(int width, int height) {
    const double aspect = static_cast<double>(height) / width;
    std::array<textures::Plane, 6> planes;
    planes.fill(textures::Plane(width, height));
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const glm::dvec2 uv((i + 0.5) / width, (j + 0.5) / height);
            const glm::dvec2 gradient = bilinearSlope(uv) / glm::dvec2(1.0, aspect);
            const glm::dvec3 normal = bilinearNormalAt(uv, aspect, 0.1);
            const std::array<double, 6> values = {bilinearDepth(uv), gradient.x, gradient.y,
                                                  normal.x,          normal.y,   normal.z};
            for (std::size_t c = 0; c < values.size(); ++c)
                planes[c].at(i, j) = static_cast<float>(values[c]);
        }
    textures::MapSet maps;
    maps.wrap = textures::WrapMode::Clamp;
    const std::array names = {"depth", "dx", "dy", "nx", "ny", "nz"};
    for (std::size_t c = 0; c < names.size(); ++c)
        maps.channels.push_back({names[c], planes[c]});
    maps.attributes["relievo:normal-scale"] = "0.1";
    return maps;
}

}  // namespace relievo::viewer
