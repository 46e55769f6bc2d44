#include "preprocess/step_field.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::WrapMode;

// The work of one thread. What others lower meanwhile does not matter: a texel that a group lowers
// in the end it would lower at any time before, and so all texels on the way there, since the
// bounds of others rise by no more than the way either.
class StepField {
  public:
    StepField(Plane& field, WrapMode wrap)
        : field_(field), wrap_(wrap), isOpened_(field.texels.size()) {}

    // From texel to texel as long as the group lowers them, or nearly.
    void lower(const std::vector<StepBound>& group) {
        // The straight line to a texel that is lowered is lowered at least as much all along. The
        // texels next to it that lead there are half a texel away from it at most, so that both
        // their distance and their way may be off by that.
        constexpr double kAstray = 1.0;
        for (const StepBound& bound : group)
            open(bound.texel);
        for (std::size_t next = 0; next < opened_.size(); ++next) {
            const glm::ivec2 texel = opened_[next];
            const std::atomic_ref<float> here(field_.at(texel.x, texel.y));
            const double most = mostAt(texel, group);
            if (!(most < static_cast<double>(here.load(std::memory_order_relaxed)) + kAstray))
                continue;
            lowerTo(here, static_cast<float>(most));
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    open({textures::wrapIndex(texel.x + x, field_.width, wrap_),
                          textures::wrapIndex(texel.y + y, field_.height, wrap_)});
        }
        for (const glm::ivec2& texel : opened_)
            isOpened_[field_.index(texel.x, texel.y)] = 0;
        opened_.clear();
    }

  private:
    static void lowerTo(const std::atomic_ref<float>& value, float most) {
        float before = value.load(std::memory_order_relaxed);
        while (most < before &&
               !value.compare_exchange_weak(before, most, std::memory_order_relaxed))
            continue;
    }

    void open(const glm::ivec2& texel) {
        std::uint8_t& isOpened = isOpened_[field_.index(texel.x, texel.y)];
        if (isOpened != 0)
            return;
        isOpened = 1;
        opened_.push_back(texel);
    }

    [[nodiscard]] double mostAt(const glm::ivec2& texel,
                                const std::vector<StepBound>& group) const {
        double most = group.front().most + way(texel, group.front().texel);
        for (const StepBound& bound : group)
            most = std::min(most, bound.most + way(texel, bound.texel));
        return most;
    }

    // Under mirror and clamp no copy of a texel is nearer than itself.
    [[nodiscard]] double way(const glm::ivec2& a, const glm::ivec2& b) const {
        int x = std::abs(a.x - b.x);
        int y = std::abs(a.y - b.y);
        if (wrap_ == WrapMode::Repeat) {
            x = std::min(x, field_.width - x);
            y = std::min(y, field_.height - y);
        }
        return std::sqrt(static_cast<double>(x) * x + static_cast<double>(y) * y);
    }

    Plane& field_;
    WrapMode wrap_;
    std::vector<std::uint8_t> isOpened_;
    std::vector<glm::ivec2> opened_;  // by the group at work
};

}  // namespace

void lowerToBounds(Plane& distance, WrapMode wrap,
                   const std::vector<std::vector<StepBound>>& groups) {
    tbb::enumerable_thread_specific<StepField> fields(
        [&distance, wrap] { return StepField(distance, wrap); });
    tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t k) {
        if (!groups[k].empty())
            fields.local().lower(groups[k]);
    });
}

}  // namespace relievo::preprocess
