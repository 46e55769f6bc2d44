#include "materials/ellipse_moments.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace relievo::materials {

EllipseMoments ellipseMoments(std::span<const textures::Plane* const> planes) {
    assert(planes.size() == 5);
    const std::size_t texels = planes[0]->texels.size();
    EllipseMoments moments;
    moments.centres.reserve(3 * texels);
    moments.squares.reserve(3 * texels);
    for (std::size_t k = 0; k < texels; ++k) {
        const float longer = planes[2]->texels[k] * planes[2]->texels[k];
        const float shorter = planes[3]->texels[k] * planes[3]->texels[k];
        const float cosine = std::cos(planes[4]->texels[k]);
        const float sine = std::sin(planes[4]->texels[k]);
        moments.centres.insert(moments.centres.end(),
                               {planes[0]->texels[k], planes[1]->texels[k], 0.0f});
        moments.squares.insert(
            moments.squares.end(),
            {cosine * cosine * longer + sine * sine * shorter, cosine * sine * (longer - shorter),
             sine * sine * longer + cosine * cosine * shorter});
    }
    return moments;
}

}  // namespace relievo::materials
