#include "viewer/reference_worker.h"

#include <algorithm>
#include <utility>

namespace relievo::viewer {
namespace {

// A frame is traced in bands of about so many rays: small enough that cancelling never takes
// longer than a picture does, large enough for all cores.
constexpr int kRaysPerBand = 8192;

MeasuredFrame band(const MeasuredFrame& frame, int firstRow, int rows) {
    const auto begin = frame.pixels.begin() + static_cast<std::ptrdiff_t>(firstRow) * frame.width;
    return {frame.width, rows, {begin, begin + static_cast<std::ptrdiff_t>(rows) * frame.width}};
}

}  // namespace

ReferenceWorker::ReferenceWorker(std::function<void()> wake) : wake_(std::move(wake)) {}

void ReferenceWorker::start(MeasuredFrame frame, const textures::DepthMap& map,
                            const glm::vec4& window, double depthScale, int lightRays) {
    cancel();
    isBusy_ = true;
    progress_ = 0.0f;
    thread_ = std::jthread([this, frame = std::move(frame), &map, window, depthScale,
                            lightRays](const std::stop_token& stop) {
        try {
            run(stop, frame, map, window, depthScale, lightRays);
        } catch (...) {
            const std::lock_guard lock(mutex_);
            failure_ = std::current_exception();
        }
        wake_();
    });
}

void ReferenceWorker::cancel() {
    if (thread_.joinable()) {
        thread_.request_stop();
        thread_.join();
    }
    const std::lock_guard lock(mutex_);
    result_.reset();
    failure_ = nullptr;
    isBusy_ = false;
}

std::optional<ReferenceFrame> ReferenceWorker::take() {
    const std::lock_guard lock(mutex_);
    if (failure_) {
        isBusy_ = false;
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
    if (result_)
        isBusy_ = false;
    return std::exchange(result_, std::nullopt);
}

void ReferenceWorker::run(const std::stop_token& stop, const MeasuredFrame& frame,
                          const textures::DepthMap& map, const glm::vec4& window, double depthScale,
                          int lightRays) {
    ReferenceFrame whole{frame.width, frame.height, {}, lightRays};
    whole.pixels.reserve(frame.pixels.size());
    const int rowsPerBand = std::max(1, kRaysPerBand / frame.width);
    for (int row = 0; row < frame.height; row += rowsPerBand) {
        if (stop.stop_requested())
            return;
        const int rows = std::min(rowsPerBand, frame.height - row);
        const ReferenceFrame traced =
            traceReference(band(frame, row, rows), map, window, depthScale, lightRays);
        whole.pixels.insert(whole.pixels.end(), traced.pixels.begin(), traced.pixels.end());
        progress_ = static_cast<float>(row + rows) / static_cast<float>(frame.height);
    }
    const std::lock_guard lock(mutex_);
    result_ = std::move(whole);
}

}  // namespace relievo::viewer
