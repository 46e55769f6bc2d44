#include "viewer/exact_tracker.h"

namespace relievo::viewer {
namespace {

constexpr std::chrono::milliseconds kStillness{250};

}  // namespace

void ExactTracker::follow(const RayKey& key, const View& view, SceneRenderer& renderer,
                          bool wanted) {
    const auto now = std::chrono::steady_clock::now();
    if (key_ != key) {
        worker_.cancel();
        frame_.reset();
        key_ = key;
        changed_ = now;
    }
    if (worker_.isBusy())
        frame_ = worker_.take();
    isWaiting_ = wanted && !frame_ && !worker_.isBusy();
    if (isWaiting_ && now - changed_ >= kStillness) {
        worker_.start(renderer.rays(view, key.width, key.height), renderer.depthMap(), view.window,
                      view.depthScale, view.lightRays);
        isWaiting_ = false;
    }
}

}  // namespace relievo::viewer
