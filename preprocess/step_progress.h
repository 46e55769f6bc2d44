#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <utility>

namespace relievo::preprocess {

/// Tells of the texels of a map while work of another measure is done: slices, levels, products.
/// After the last step as many were told of as there are.
class StepProgress {
  public:
    using Advance = std::function<void(std::size_t)>;

    /// `advance` as in MapRequest, and may be empty; `steps` ≥ 1 make up the work on `texels`.
    StepProgress(Advance advance, std::size_t texels, std::size_t steps)
        : advance_(std::move(advance)), texels_(texels), steps_(steps) {}

    /// So many more steps are done. May be called from any thread.
    void done(std::size_t steps = 1) {
        const std::size_t before = done_.fetch_add(steps);
        if (advance_)
            advance_(texelsAfter(before + steps) - texelsAfter(before));
    }

  private:
    [[nodiscard]] std::size_t texelsAfter(std::size_t steps) const {
        const double share = static_cast<double>(steps) / static_cast<double>(steps_);
        return steps == steps_ ? texels_
                               : static_cast<std::size_t>(share * static_cast<double>(texels_));
    }

    Advance advance_;
    std::size_t texels_;
    std::size_t steps_;
    std::atomic<std::size_t> done_{0};
};

}  // namespace relievo::preprocess
