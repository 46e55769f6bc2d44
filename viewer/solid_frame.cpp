#include "viewer/solid_frame.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "textures/input_error.h"

namespace relievo::viewer {
namespace {

// Counting work on every fourth pixel of every fourth row is enough for means.
constexpr int kCoarseness = 4;
// The share of the newest frame in the smoothed time.
constexpr double kNewest = 0.2;

std::unique_ptr<SolidSession> openSession(const ViewOptions& options) {
    return std::make_unique<SolidSession>(
        options, materials::findSolidTechnique(options.techniques.front()));
}

}  // namespace

SolidFrame::SolidFrame(const ViewOptions& options) : session_(openSession(options)) {}

bool SolidFrame::update(const ViewOptions& options, int width, int height) {
    const bool isResized = picture_.width() != width || picture_.height() != height;
    if (isResized)
        picture_ = gl::Framebuffer(width, height, std::array<GLenum, 1>{GL_RGBA8});
    if (!isResized && drawn_ == options)
        return false;
    redraw(options);
    drawn_ = options;
    return true;
}

void SolidFrame::redraw(const ViewOptions& options) {
    try {
        const bool isOtherTechnique =
            session_->technique().technique.name != options.techniques.front();
        if (isOtherTechnique)
            session_ = openSession(options);
        session_->edit(options);
        // The first may have to compile programs and upload maps: it counts for nothing.
        drawTimed(options);
        if (!drawn_ || isOtherTechnique)
            readings_.milliseconds.reset();
        readings_.problem.clear();
    } catch (const textures::InputError& error) {
        readings_ = {};
        readings_.problem = error.what();
        picture_.clearColor(0, 0.09f, 0.09f, 0.1f, 1.0f);
    }
}

void SolidFrame::drawTimed(const ViewOptions& options) {
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    session_->draw(options, picture_);
    glFinish();
    const double time =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    readings_.milliseconds =
        readings_.milliseconds ? std::lerp(*readings_.milliseconds, time, kNewest) : time;
}

void SolidFrame::measure() {
    readings_.work.reset();
    if (!session_->shape() || !drawn_ || !readings_.problem.empty())
        return;
    readings_.work =
        countWork(session_->measure(*drawn_, std::max(1, picture_.width() / kCoarseness),
                                    std::max(1, picture_.height() / kCoarseness)));
}

}  // namespace relievo::viewer
