#include "preprocess/ambient_occlusion.h"

#include <cassert>
#include <cstddef>

namespace relievo::preprocess {

textures::Plane buildOcclusion(std::span<const textures::Plane* const> horizons,
                               double depthScale) {
    assert(!horizons.empty() && depthScale >= 0.0);
    textures::Plane occlusion(horizons.front()->width, horizons.front()->height);
    for (std::size_t k = 0; k < occlusion.texels.size(); ++k) {
        double open = 0.0;
        for (const textures::Plane* const horizon : horizons) {
            const double tangent = depthScale * horizon->texels[k];
            open += 1.0 / (1.0 + tangent * tangent);
        }
        occlusion.texels[k] = static_cast<float>(open / static_cast<double>(horizons.size()));
    }
    return occlusion;
}

}  // namespace relievo::preprocess
