#include "viewer/solid_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "textures/input_error.h"

namespace relievo::viewer {
namespace {

using Clock = std::chrono::steady_clock;

// Every fourth pixel of every fourth row is enough for a draft, and for counting means of work.
constexpr int kCoarseness = 4;
// The share of the newest frame in the smoothed time.
constexpr double kNewest = 0.2;

std::unique_ptr<SolidSession> openSession(const ViewOptions& options) {
    return std::make_unique<SolidSession>(
        options, materials::findSolidTechnique(options.techniques.front()));
}

gl::Framebuffer makeTarget(int width, int height) {
    return {width, height, std::array<GLenum, 1>{GL_RGBA8}};
}

}  // namespace

SolidFrame::SolidFrame(const ViewOptions& options, std::chrono::milliseconds patience)
    : patience_(patience), session_(openSession(options)) {}

bool SolidFrame::isOf(const ViewOptions& options, int width, int height) const {
    return asked_ == options && next_.width() == width && next_.height() == height;
}

bool SolidFrame::update(const ViewOptions& options, int width, int height) {
    try {
        if (!isOf(options, width, height)) {
            begin(options, width, height);
            if (!hasPrograms_)
                return isFinished_;
        } else if (isFinished_) {
            return false;
        }
        const Clock::time_point end = Clock::now() + patience_;
        do
            step();
        while (!isFinished_ && Clock::now() < end);
        if (!isFinished_)
            showDraft();
    } catch (const textures::InputError& error) {
        fail(error.what());
    }
    return isFinished_;
}

bool SolidFrame::finish() {
    if (isFinished_)
        return false;
    try {
        while (!isFinished_)
            step();
    } catch (const textures::InputError& error) {
        fail(error.what());
    }
    return true;
}

std::optional<SolidProgress> SolidFrame::progress() const {
    return isFinished_ ? std::nullopt : std::optional(session_->progress());
}

void SolidFrame::begin(const ViewOptions& options, int width, int height) {
    asked_ = options;
    isFinished_ = false;
    spent_ = 0.0;
    readings_.problem.clear();
    if (next_.width() != width || next_.height() != height)
        next_ = makeTarget(width, height);
    if (session_->technique().technique.name != options.techniques.front()) {
        session_ = openSession(options);
        hasPrograms_ = false;
        readings_.milliseconds.reset();
    }
    session_->edit(options);
    session_->begin(options, next_);
    if (!hasPrograms_)
        showDraft();
}

// Shows at once roughly what next_ will show, unless what is shown is as near to it.
void SolidFrame::showDraft() {
    const bool fits = picture_.width() == next_.width() && picture_.height() == next_.height();
    const bool isSame = fits && shownFrom_ == asked_->camera;
    if (isSame && (hasPrograms_ || session_->progress().isOfShadows))
        return;
    if (!fits)
        picture_ = makeTarget(next_.width(), next_.height());
    shownFrom_ = asked_->camera;
    if (!hasPrograms_) {
        session_->showUnfinished(picture_);
        return;
    }
    gl::Framebuffer draft = makeTarget(std::max(1, next_.width() / kCoarseness),
                                       std::max(1, next_.height() / kCoarseness));
    session_->draft(*asked_, draft);
    glBlitNamedFramebuffer(draft.id(), picture_.id(), 0, 0, draft.width(), draft.height(), 0, 0,
                           picture_.width(), picture_.height(), GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

void SolidFrame::step() {
    const Clock::time_point start = Clock::now();
    const bool isUnfinished = session_->step();
    glFinish();
    spent_ += std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    if (isUnfinished)
        return;
    showNext();
    // The first may have to compile programs and upload maps: it counts for nothing.
    if (hasPrograms_)
        readings_.milliseconds =
            readings_.milliseconds ? std::lerp(*readings_.milliseconds, spent_, kNewest) : spent_;
    hasPrograms_ = true;
}

void SolidFrame::showNext() {
    if (picture_.width() != next_.width() || picture_.height() != next_.height())
        picture_ = makeTarget(next_.width(), next_.height());
    std::swap(picture_, next_);
    shownFrom_ = asked_->camera;
    isFinished_ = true;
}

void SolidFrame::fail(const std::string& problem) {
    readings_ = {};
    readings_.problem = problem;
    next_.clearColor(0, 0.09f, 0.09f, 0.1f, 1.0f);
    showNext();
}

void SolidFrame::measure() {
    readings_.work.reset();
    if (!session_->shape() || !isFinished_ || !asked_ || !readings_.problem.empty())
        return;
    readings_.work =
        countWork(session_->measure(*asked_, std::max(1, picture_.width() / kCoarseness),
                                    std::max(1, picture_.height() / kCoarseness)));
}

}  // namespace relievo::viewer
