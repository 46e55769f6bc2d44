#include "viewer/measured_frame.h"

#include <array>

#include "shaders/relievo/constants.h"

namespace relievo::viewer {

gl::Framebuffer makeMeasuredTarget(int width, int height) {
    std::array<GLenum, RELIEVO_OUTPUT_COUNT> formats;
    formats.fill(GL_RGBA32F);
    return gl::Framebuffer(width, height, formats);
}

MeasuredFrame readMeasuredFrame(const gl::Framebuffer& target) {
    MeasuredFrame frame{target.width(), target.height(), {}};
    frame.pixels.resize(static_cast<std::size_t>(frame.width) *
                        static_cast<std::size_t>(frame.height));
    const auto forEach = [&](int attachment, auto&& assign) {
        const std::vector<float> texels = target.read(attachment);
        for (std::size_t k = 0; k < frame.pixels.size(); ++k)
            assign(frame.pixels[k], &texels[4 * k]);
    };
    forEach(RELIEVO_OUTPUT_HIT, [](MeasuredPixel& pixel, const float* value) {
        pixel.hit = {value[0], value[1], value[2]};
        pixel.t = value[3];
    });
    forEach(RELIEVO_OUTPUT_WORK, [](MeasuredPixel& pixel, const float* value) {
        pixel.outcome = static_cast<int>(value[0]);
        pixel.steps = static_cast<int>(value[1]);
        pixel.fetches = static_cast<int>(value[2]);
        pixel.covered = value[3] > 0.0f;
    });
    forEach(RELIEVO_OUTPUT_ORIGIN, [](MeasuredPixel& pixel, const float* value) {
        pixel.origin = {value[0], value[1], value[2]};
        pixel.end = value[3];
    });
    forEach(RELIEVO_OUTPUT_DIRECTION, [](MeasuredPixel& pixel, const float* value) {
        pixel.direction = {value[0], value[1], value[2]};
    });
    forEach(RELIEVO_OUTPUT_NORMAL, [](MeasuredPixel& pixel, const float* value) {
        pixel.normal = {value[0], value[1], value[2]};
    });
    forEach(RELIEVO_OUTPUT_LIGHT, [](MeasuredPixel& pixel, const float* value) {
        pixel.light = {value[0], value[1], value[2]};
        pixel.lightShare = value[3];
    });
    forEach(RELIEVO_OUTPUT_LIFT, [](MeasuredPixel& pixel, const float* value) {
        pixel.lift = {value[0], value[1], value[2]};
        pixel.shadowFetches = static_cast<int>(value[3]);
    });
    forEach(RELIEVO_OUTPUT_SIDE, [](MeasuredPixel& pixel, const float* value) {
        pixel.side = {value[0], value[1], value[2]};
    });
    return frame;
}

WorkCounts countWork(const MeasuredFrame& frame) {
    WorkCounts counts;
    double steps = 0.0;
    double fetches = 0.0;
    for (const MeasuredPixel& pixel : frame.pixels) {
        if (!pixel.covered)
            continue;
        ++counts.pixels;
        counts.exhausted += pixel.outcome == RELIEVO_OUTCOME_EXHAUSTED;
        steps += pixel.steps;
        fetches += pixel.fetches;
    }
    if (counts.pixels > 0) {
        counts.meanSteps = steps / static_cast<double>(counts.pixels);
        counts.meanFetches = fetches / static_cast<double>(counts.pixels);
    }
    return counts;
}

}  // namespace relievo::viewer
