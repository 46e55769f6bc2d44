#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>

#include "viewer/reference_worker.h"
#include "viewer/scene_renderer.h"
#include "viewer/window_settings.h"

namespace relievo::viewer {

/// What decides the rays of a picture, and so its exact hits: not the technique, and the light only
/// where there are shadows.
struct RayKey {
    struct Light {
        glm::vec2 direction;
        float size;

        friend bool operator==(const Light&, const Light&) = default;
    };

    std::size_t file = 0;
    ObjectKind object = ObjectKind::Quad;
    glm::vec2 tiles{1.0f};
    float depthScale = 0.0f;
    OrbitCamera camera;
    std::optional<Light> light;
    int width = 0;
    int height = 0;

    friend bool operator==(const RayKey&, const RayKey&) = default;
};

/// Keeps the exact hits of what a window shows: traces them in the background once the view has
/// been still for a moment, and forgets them as soon as it moves.
class ExactTracker {
  public:
    /// `wake` is called on another thread when there is something new for follow().
    explicit ExactTracker(std::function<void()> wake) : worker_(std::move(wake)) {}

    /// To be called for every frame of the window with what it shows: a picture of
    /// `key.width`×`key.height` of `view`. Starts tracing when the exact hits are `wanted`, missing
    /// and the view has been still. `renderer` must outlive the tracker.
    void follow(const RayKey& key, const View& view, SceneRenderer& renderer, bool wanted);

    /// The exact hits of the view that was followed last, or null while they are not known.
    [[nodiscard]] const ReferenceFrame* frame() const noexcept {
        return frame_ ? &*frame_ : nullptr;
    }
    [[nodiscard]] bool isTracing() const noexcept { return worker_.isBusy(); }
    /// Whether tracing waits for the view to stay still: follow() must be called again soon.
    [[nodiscard]] bool isWaiting() const noexcept { return isWaiting_; }
    [[nodiscard]] float progress() const noexcept { return worker_.progress(); }

  private:
    std::optional<RayKey> key_;
    std::chrono::steady_clock::time_point changed_;
    std::optional<ReferenceFrame> frame_;
    bool isWaiting_ = false;
    ReferenceWorker worker_;
};

}  // namespace relievo::viewer
