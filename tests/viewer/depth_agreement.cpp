#include "depth_agreement.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <limits>

namespace relievo::viewer {

double depthBound(const Camera& camera, const glm::dvec3& position, double length) {
    constexpr double kEpsilon = std::numeric_limits<float>::epsilon() / 2;
    const glm::dmat4 matrix(camera.viewProjection);
    const glm::dvec4 point(position, 1.0);
    glm::dvec4 magnitude(0.0);
    for (int column = 0; column < 4; ++column)
        magnitude += glm::abs(matrix[column] * point[column]);
    const glm::dvec4 clip = matrix * point;
    const double device = clip.z / clip.w;
    const double product = 4 * kEpsilon * (magnitude.z + std::abs(device) * magnitude.w);
    double moved = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        moved += 16 * kEpsilon * length * std::abs(matrix[axis].z - device * matrix[axis].w);
    const double share = (camera.depth.zeroToOne ? 1.0 : 0.5) * (product + moved) / clip.w;
    // The depth range, and the depth buffer.
    return static_cast<double>(std::abs(camera.depth.range.y - camera.depth.range.x)) * share +
           4 * kEpsilon;
}

DepthAgreement compareDepths(std::span<const float> depths,
                             std::span<const std::optional<ExactHit>> hits, const Camera& camera,
                             double length) {
    const float clear = fallsWithDistance(camera.depth) ? 0.0f : 1.0f;
    DepthAgreement agreement;
    for (std::size_t k = 0; k < depths.size(); ++k) {
        const bool isDrawn = depths[k] != clear;
        agreement.differing += isDrawn != hits[k].has_value();
        if (!isDrawn || !hits[k])
            continue;
        ++agreement.compared;
        const double exact = windowDepth(camera, hits[k]->position);
        const double bound = depthBound(camera, hits[k]->position, length);
        const double difference = std::abs(static_cast<double>(depths[k]) - exact);
        agreement.beyond += difference > bound;
        agreement.worst = std::max(agreement.worst, difference / bound);
    }
    return agreement;
}

}  // namespace relievo::viewer
