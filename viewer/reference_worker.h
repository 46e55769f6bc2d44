#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <glm/vec4.hpp>
#include <mutex>
#include <optional>
#include <thread>

#include "textures/depth_map.h"
#include "viewer/measured_frame.h"
#include "viewer/reference_frame.h"

namespace relievo::viewer {

/// Traces exact frames on a thread of its own, one at a time, so that a window stays alive. To be
/// used from one thread.
class ReferenceWorker {
  public:
    /// `wake` is called on the worker's thread whenever a frame is done.
    explicit ReferenceWorker(std::function<void()> wake);

    /// Starts tracing the rays of `frame` (see traceReference) in place of whatever was under way.
    /// `map` must stay unchanged until the frame is done or cancelled, or the worker destroyed.
    void start(MeasuredFrame frame, const textures::DepthMap& map, const glm::vec4& window,
               double depthScale, int lightRays);
    /// Drops what is under way, and a result that was not taken.
    void cancel();
    /// Whether a frame was started that take() has not returned.
    [[nodiscard]] bool isBusy() const noexcept { return isBusy_; }
    /// The share of the rays that are traced, in [0,1].
    [[nodiscard]] float progress() const noexcept { return progress_; }
    /// The frame that was started last, once it is done. Throws what tracing threw.
    std::optional<ReferenceFrame> take();

  private:
    void run(const std::stop_token& stop, const MeasuredFrame& frame, const textures::DepthMap& map,
             const glm::vec4& window, double depthScale, int lightRays);

    std::function<void()> wake_;
    bool isBusy_ = false;
    std::atomic<float> progress_{0.0f};
    std::mutex mutex_;  // of what the worker hands over: the two members below
    std::optional<ReferenceFrame> result_;
    std::exception_ptr failure_;
    std::jthread thread_;  // last, so that it ends before the rest goes
};

}  // namespace relievo::viewer
