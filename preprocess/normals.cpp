#include "preprocess/normals.h"

#include <cassert>
#include <cmath>

namespace relievo::preprocess {

Normals buildNormals(const Derivatives& derivatives, double depthScale) {
    assert(depthScale >= 0.0);
    const int width = derivatives.dx.width;
    const int height = derivatives.dx.height;
    Normals normals{textures::Plane(width, height), textures::Plane(width, height),
                    textures::Plane(width, height)};
    for (std::size_t k = 0; k < derivatives.dx.texels.size(); ++k) {
        const double x = depthScale * derivatives.dx.texels[k];
        const double y = depthScale * derivatives.dy.texels[k];
        const double length = std::sqrt(x * x + y * y + 1.0);
        normals.nx.texels[k] = static_cast<float>(x / length);
        normals.ny.texels[k] = static_cast<float>(y / length);
        normals.nz.texels[k] = static_cast<float>(1.0 / length);
    }
    return normals;
}

}  // namespace relievo::preprocess
