#include "reference/cell_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo::reference {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

AxisWalk::AxisWalk(double texels, double speed, int size, textures::WrapMode wrap)
    : speed_(speed), size_(size), wrap_(wrap) {
    cell_ = static_cast<std::int64_t>(std::floor(texels));
    if (wrap == textures::WrapMode::Clamp)
        cell_ = std::clamp<std::int64_t>(cell_, -1, size - 1);
    start_ = texels - static_cast<double>(cell_);
    low_ = textures::wrapIndex(cell_, size_, wrap_);
    high_ = textures::wrapIndex(cell_ + 1, size_, wrap_);
}

double AxisWalk::exit() const noexcept {
    if (speed_ == 0.0 || reachesToInfinity())
        return kInfinity;
    const auto border = static_cast<double>(speed_ > 0.0 ? steps_ + 1 : steps_);
    return (border - start_) / speed_;
}

void AxisWalk::step() noexcept {
    if (speed_ > 0.0) {
        ++cell_, ++steps_;
        low_ = high_;
        high_ = textures::wrapIndex(cell_ + 1, size_, wrap_);
    } else {
        --cell_, --steps_;
        high_ = low_;
        low_ = textures::wrapIndex(cell_, size_, wrap_);
    }
}

void AxisWalk::jump(double t) noexcept {
    if (speed_ == 0.0)
        return;
    const auto target = static_cast<std::int64_t>(std::floor(start_ + t * speed_));
    std::int64_t steps = speed_ > 0.0 ? std::max(target, steps_) : std::min(target, steps_);
    if (wrap_ == textures::WrapMode::Clamp) {
        const std::int64_t first = cell_ - steps_;
        steps = std::clamp<std::int64_t>(first + steps, -1, size_ - 1) - first;
    }
    cell_ += steps - steps_;
    steps_ = steps;
    low_ = textures::wrapIndex(cell_, size_, wrap_);
    high_ = textures::wrapIndex(cell_ + 1, size_, wrap_);
}

bool AxisWalk::reachesToInfinity() const noexcept {
    if (size_ == 1)
        return true;
    return wrap_ == textures::WrapMode::Clamp && (speed_ > 0.0 ? cell_ >= size_ - 1 : cell_ <= -1);
}

CellWalk::CellWalk(const textures::DepthMap& map, const glm::dvec3& start,
                   const glm::dvec3& direction, double end)
    : map_(&map),
      columns_(start.x * map.width() - 0.5, direction.x * map.width(), map.width(), map.wrap),
      rows_(start.y * map.height() - 0.5, direction.y * map.height(), map.height(), map.wrap),
      direction_(columns_.speed(), rows_.speed(), direction.z),
      z_(start.z),
      end_(end) {
    columnExit_ = columns_.exit();
    rowExit_ = rows_.exit();
    findExit();
}

// Two borders met at once may swap by a rounding; the parameter must not go back for it.
void CellWalk::findExit() noexcept {
    exit_ = std::max(entry_, std::min({columnExit_, rowExit_, end_}));
}

void CellWalk::step() noexcept {
    entry_ = exit_;
    if (columnExit_ <= rowExit_) {
        columns_.step();
        columnExit_ = columns_.exit();
    } else {
        rows_.step();
        rowExit_ = rows_.exit();
    }
    findExit();
}

void CellWalk::jump(double t) noexcept {
    entry_ = t;
    columns_.jump(t);
    rows_.jump(t);
    columnExit_ = columns_.exit();
    rowExit_ = rows_.exit();
    findExit();
}

BilinearCell CellWalk::surface() const noexcept {
    const textures::Plane& depth = map_->depth;
    return {depth.at(columns_.low(), rows_.low()), depth.at(columns_.high(), rows_.low()),
            depth.at(columns_.low(), rows_.high()), depth.at(columns_.high(), rows_.high())};
}

DepthBelowSurface CellWalk::below(const BilinearCell& cell) const noexcept {
    return depthBelowSurface(cell, glm::dvec3(local(entry_), z(entry_)), direction_);
}

}  // namespace relievo::reference
