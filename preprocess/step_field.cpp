#include "preprocess/step_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::WrapMode;

class StepField {
  public:
    StepField(Plane& field, WrapMode wrap)
        : field_(field), wrap_(wrap), visits_(field.texels.size()) {}

    // From texel to texel as long as the group lowers them, or nearly.
    void lower(const std::vector<StepBound>& group) {
        // The straight line to a texel that is lowered is lowered at least as much all along. The
        // texels next to it that lead there are half a texel away from it at most, so that both
        // their distance and their way may be off by that.
        constexpr double kAstray = 1.0;
        ++visit_;
        for (const StepBound& bound : group)
            open(bound.texel);
        while (!open_.empty()) {
            const glm::ivec2 texel = open_.back();
            open_.pop_back();
            float& here = field_.at(texel.x, texel.y);
            const double most = mostAt(texel, group);
            if (!(most < here + kAstray))
                continue;
            here = std::min(here, static_cast<float>(most));
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    open({textures::wrapIndex(texel.x + x, field_.width, wrap_),
                          textures::wrapIndex(texel.y + y, field_.height, wrap_)});
        }
    }

  private:
    void open(const glm::ivec2& texel) {
        std::uint32_t& visit = visits_[field_.index(texel.x, texel.y)];
        if (visit == visit_)
            return;
        visit = visit_;
        open_.push_back(texel);
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
    std::vector<std::uint32_t> visits_;  // by which group a texel was opened last
    std::uint32_t visit_ = 0;
    std::vector<glm::ivec2> open_;
};

}  // namespace

void lowerToBounds(Plane& distance, WrapMode wrap,
                   const std::vector<std::vector<StepBound>>& groups) {
    StepField field(distance, wrap);
    for (const std::vector<StepBound>& group : groups)
        if (!group.empty())
            field.lower(group);
}

}  // namespace relievo::preprocess
