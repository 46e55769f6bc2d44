#include "viewer/visible_frame.h"

#include <array>

#include "shaders/relievo/constants.h"

namespace relievo::viewer {

gl::Framebuffer makeVisibleTarget(int width, int height) {
    return gl::Framebuffer(width, height, std::array<GLenum, 2>{GL_RGBA32F, GL_RGBA32F});
}

VisibleFrame readVisibleFrame(const gl::Framebuffer& target) {
    const std::vector<float> points = target.read(RELIEVO_VISIBLE_POINT);
    const std::vector<float> lights = target.read(RELIEVO_VISIBLE_LIGHT);
    VisibleFrame frame{target.width(), target.height(), {}, 0};
    frame.pixels.resize(points.size() / 4);
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
        const float* point = &points[4 * k];
        frame.pixels[k] = {
            static_cast<int>(point[3]) - 1, {point[0], point[1], point[2]}, lights[4 * k] > 0.5f};
    }
    return frame;
}

}  // namespace relievo::viewer
