#include "viewer/error_image.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace relievo::viewer {
namespace {

PixelVerdict judge(const reference::HitComparison& comparison) {
    if (!comparison.converged)
        return PixelVerdict::Exhausted;
    return comparison.found == comparison.exists ? PixelVerdict::Compared : PixelVerdict::Mismatch;
}

double angleDegrees(const glm::dvec3& a, const glm::dvec3& b) {
    // atan2 keeps its precision at small angles, where acos has none.
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

}  // namespace

ErrorImage makeErrorImage(const MeasuredFrame& frame, const ReferenceFrame& reference,
                          const textures::DepthMap& map, double depthScale) {
    const textures::Plane empty(frame.width, frame.height);
    ErrorImage image{empty, empty, empty, empty, empty};
    const std::vector<reference::HitComparison> comparisons =
        compareFrames(frame, reference, map, depthScale);
    auto comparison = comparisons.begin();
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
        const MeasuredPixel& pixel = frame.pixels[k];
        PixelVerdict verdict = PixelVerdict::Uncovered;
        if (pixel.covered) {
            verdict = judge(*comparison);
            if (comparison->found && comparison->exists) {
                const double error = comparison->distance - comparison->exactDistance;
                image.distance.texels[k] = static_cast<float>(error * map.width());
                image.normalAngle.texels[k] =
                    static_cast<float>(angleDegrees(comparison->normal, comparison->exactNormal));
            }
            ++comparison;
        }
        image.verdict.texels[k] = static_cast<float>(static_cast<int>(verdict));
        image.steps.texels[k] = static_cast<float>(pixel.steps);
        image.fetches.texels[k] = static_cast<float>(pixel.fetches);
    }
    return image;
}

std::vector<NamedPlane> namedPlanes(const ErrorImage& image, const std::string& prefix) {
    return {{prefix + ".distance", image.distance},
            {prefix + ".normal_angle", image.normalAngle},
            {prefix + ".verdict", image.verdict},
            {prefix + ".steps", image.steps},
            {prefix + ".fetches", image.fetches}};
}

}  // namespace relievo::viewer
