#include "viewer/scene_errors.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

namespace relievo::viewer {
namespace {

glm::dvec2 onScreen(const Camera& camera, const glm::dvec3& point, const VisibleFrame& frame) {
    const glm::dvec4 clip = glm::dmat4(camera.viewProjection) * glm::dvec4(point, 1.0);
    return 0.5 * glm::dvec2(frame.width, frame.height) * glm::dvec2(clip) / clip.w;
}

// A hit and the exact one lie on one ray, so that they are the same point of the picture. What is
// compared is where the points of the surface are seen that lie above them.
double shiftOf(const VisiblePixel& pixel, const ExactHit& exact, const Camera& camera,
               const VisibleFrame& frame) {
    const glm::dvec3 apart = glm::dvec3(pixel.position) - exact.position;
    const glm::dvec3 along = apart - glm::dot(apart, exact.surfaceNormal) * exact.surfaceNormal;
    return glm::distance(onScreen(camera, exact.position, frame),
                         onScreen(camera, exact.position + along, frame));
}

// Whether the exact picture shows the object (−1: none) in the pixel or next to it: its border may
// be out of place by a pixel, like any other point of it.
bool isShownAround(std::span<const std::optional<ExactHit>> exact, const VisibleFrame& frame,
                   std::size_t pixel, int object) {
    const int x = static_cast<int>(pixel) % frame.width;
    const int y = static_cast<int>(pixel) / frame.width;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, frame.height - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, frame.width - 1); ++i) {
            const auto& hit = exact[static_cast<std::size_t>(j * frame.width + i)];
            if ((hit ? static_cast<int>(hit->object) : -1) == object)
                return true;
        }
    return false;
}

}  // namespace

SceneErrors compareScene(const VisibleFrame& frame, std::span<const std::optional<ExactHit>> exact,
                         const Camera& camera) {
    assert(frame.pixels.size() == exact.size());
    SceneErrors errors;
    std::size_t wrongObjects = 0;
    std::size_t wrong = 0;
    double shifts = 0.0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
        const int object = exact[k] ? static_cast<int>(exact[k]->object) : -1;
        const VisiblePixel& pixel = frame.pixels[k];
        errors.pixels += object >= 0 || pixel.object >= 0;
        if (pixel.object != object) {
            ++wrongObjects;
            wrong += !isShownAround(exact, frame, k, pixel.object);
        }
        if (object < 0 || pixel.object != object)
            continue;
        const double shift = shiftOf(pixel, *exact[k], camera, frame);
        wrong += shift > 1.0;
        shifts += shift;
    }
    if (errors.pixels == 0)
        return errors;
    const auto pixels = static_cast<double>(errors.pixels);
    errors.wrongObjectShare = static_cast<double>(wrongObjects) / pixels;
    errors.wrongShare = static_cast<double>(wrong) / pixels;
    errors.meanShift = shifts / pixels;
    return errors;
}

}  // namespace relievo::viewer
