#include "viewer/light_errors.h"

#include <cassert>
#include <cmath>

#include "shaders/relievo/constants.h"

namespace relievo::viewer {
namespace {

bool isCompared(const MeasuredPixel& pixel, const ReferencePixel& exact) {
    return pixel.covered && pixel.outcome == RELIEVO_OUTCOME_HIT && exact.hit;
}

}  // namespace

LightErrors summarizeLight(const MeasuredFrame& frame, const ReferenceFrame& exact) {
    assert(frame.pixels.size() == exact.pixels.size() && exact.lightRays > 0);
    LightErrors errors;
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
        if (!isCompared(frame.pixels[k], exact.pixels[k]))
            continue;
        const double error =
            std::abs(static_cast<double>(frame.pixels[k].lightShare) - exact.pixels[k].lightShare);
        ++errors.pixels;
        // Not the other way round, so that what is no number is wrong too.
        wrong += !(error <= kWrongLight);
        errors.meanError += error;
        errors.meanFetches += frame.pixels[k].shadowFetches;
    }
    if (errors.pixels > 0) {
        const auto pixels = static_cast<double>(errors.pixels);
        errors.wrongShare = static_cast<double>(wrong) / pixels;
        errors.meanError /= pixels;
        errors.meanFetches /= pixels;
    }
    return errors;
}

textures::Plane lightErrorPlane(const MeasuredFrame& frame, const ReferenceFrame& exact) {
    assert(frame.pixels.size() == exact.pixels.size());
    textures::Plane plane(frame.width, frame.height);
    for (std::size_t k = 0; k < frame.pixels.size(); ++k)
        if (isCompared(frame.pixels[k], exact.pixels[k]))
            plane.texels[k] =
                frame.pixels[k].lightShare - static_cast<float>(exact.pixels[k].lightShare);
    return plane;
}

}  // namespace relievo::viewer
