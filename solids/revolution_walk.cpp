#include "solids/revolution_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace relievo::solids {
namespace {

using reference::AxisWalk;
using reference::BilinearCell;
using reference::ShapeCell;
using textures::wrapIndex;
using textures::WrapMode;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The walk over tiles: cells of an axis with as many "texels" as tiles, whatever those hold.
AxisWalk tileWalk(double start, double speed) {
    return {start, speed, 2, WrapMode::Repeat};
}

}  // namespace

RevolutionWalk::RevolutionWalk(const Solid& solid, const FreeSpace* freeSpace, const WalkSpan& span,
                               TraceCost* cost)
    : solid_(&solid),
      freeSpace_(freeSpace),
      span_(span),
      cost_(cost),
      tiles_{tileWalk(span.start.x, span.direction.x), tileWalk(span.start.y, span.direction.y),
             tileWalk(span.start.z, span.direction.z)} {
    // A ray that comes in through the far border of a tile is in that tile, not in the next one.
    for (int axis = 0; axis < 3; ++axis)
        if (tiles_[axis].local(0.0) == 0.0 && span.direction[axis] < 0.0)
            tiles_[axis].step();
    enterReplica();
}

std::optional<SolidCrossing> RevolutionWalk::next() {
    while (firstPending_ == pending_.size()) {
        if (isDone_)
            return std::nullopt;
        pending_.clear();
        firstPending_ = 0;
        walkOn();
    }
    return pending_[firstPending_++];
}

void RevolutionWalk::enterReplica() {
    const glm::dvec3 place(tiles_[0].local(replicaEntry_), tiles_[1].local(replicaEntry_),
                           tiles_[2].local(replicaEntry_));
    const double height = solid_->shape->height();
    const bool isUpsideDown =
        solid_->shape->wrap == WrapMode::Mirror && (tiles_[2].cell() & 1) != 0;
    section_.sign = isUpsideDown ? -1.0 : 1.0;
    section_.rows = AxisWalk((isUpsideDown ? 1.0 - place.z : place.z) * height - 0.5,
                             section_.sign * span_.direction.z * height, solid_->shape->height(),
                             WrapMode::Clamp);
    section_.start = glm::dvec2(place) - solid_->axis;
    const glm::dvec2 direction(span_.direction);
    const double speed = std::hypot(direction.x, direction.y);
    // Slower than this the ray does not move away from where it is by a digit: it is along the
    // axis.
    const bool isAlongAxis = speed < 0x1p-60 * std::abs(span_.direction.z) || speed == 0.0;
    if (isAlongAxis) {
        section_.line = {std::hypot(section_.start.x, section_.start.y), 0.0, 0.0};
    } else {
        const glm::dvec2 n = direction / speed;
        section_.line = {std::abs(section_.start.x * n.y - section_.start.y * n.x),
                         glm::dot(section_.start, n), speed};
    }
    turn_ = isAlongAxis ? kInfinity : -section_.line.start / speed;
    section_.goesInwards = section_.line.start < 0.0;
    section_.column = columnOf(section_.line.radius(0.0));
    double end = span_.end;
    for (const AxisWalk& tile : tiles_)
        end = std::min(end, tile.exit());
    section_.end = std::max(0.0, end - replicaEntry_);
    entry_ = 0.0;
    findExit();
}

void RevolutionWalk::leaveReplica() {
    borderAxis_ = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (tiles_[axis].exit() < tiles_[borderAxis_].exit())
            borderAxis_ = axis;
    const double exit = tiles_[borderAxis_].exit();
    if (exit >= span_.end) {
        isDone_ = true;
        if (isInside_ && span_.exitAxis >= 0)
            toggle(span_.end, SolidFace::Cap, flatOutward(span_.exitAxis));
        return;
    }
    replicaEntry_ = std::max(replicaEntry_, exit);
    tiles_[borderAxis_].step();
    enterReplica();
}

int RevolutionWalk::columnOf(double radius) const noexcept {
    const double column = std::floor(radius * solid_->shape->width() - 0.5);
    return static_cast<int>(std::clamp(column, -1.0, solid_->shape->width() - 1.0));
}

// Where the ray leaves the current column of cells, or is closest to the axis in it.
double RevolutionWalk::columnExit() const noexcept {
    const RadialLine& line = section_.line;
    if (line.speed == 0.0)
        return kInfinity;
    const double columns = solid_->shape->width();
    const auto along = [&](double border) {
        return std::sqrt((border - line.closest) * (border + line.closest));
    };
    if (section_.goesInwards) {
        const double border = (section_.column + 0.5) / columns;
        if (section_.column < 0 || border <= line.closest)
            return turn_;
        return (-along(border) - line.start) / line.speed;
    }
    if (section_.column >= solid_->shape->width() - 1)
        return kInfinity;
    const double border = (section_.column + 1.5) / columns;
    return border <= line.closest ? turn_ : (along(border) - line.start) / line.speed;
}

void RevolutionWalk::findExit() noexcept {
    exit_ = std::max(entry_, std::min({columnExit(), section_.rows.exit(), section_.end}));
}

void RevolutionWalk::step() noexcept {
    const double column = columnExit();
    entry_ = exit_;
    if (column <= section_.rows.exit()) {
        if (!section_.goesInwards)
            ++section_.column;
        else if (column == turn_)
            section_.goesInwards = false;
        else
            --section_.column;
    } else {
        section_.rows.step();
    }
    findExit();
}

// Over the ball around the entry that is all outside or all inside, if that leads out of the cell.
bool RevolutionWalk::jump(double distance) noexcept {
    if (freeSpace_ == nullptr)
        return false;
    const double radius = freeSpace_->radius(distance, solid_->extension, solid_->extension);
    if (radius < 1.0)
        return false;
    const double speed =
        std::hypot(section_.line.speed * solid_->shape->width(), section_.rows.speed());
    const double target = speed > 0.0 ? entry_ + radius / speed : kInfinity;
    if (!(target > exit_))
        return false;
    entry_ = std::min(target, section_.end);
    if (entry_ < section_.end) {
        section_.rows.jump(entry_);
        section_.goesInwards = section_.line.along(entry_) < 0.0;
        section_.column = columnOf(section_.line.radius(entry_));
    }
    findExit();
    return true;
}

// A field of the cell that the ray is in.
SectionCell RevolutionWalk::sectionCell(const BilinearCell& field,
                                        double extension) const noexcept {
    return {field,
            section_.line,
            static_cast<double>(solid_->shape->width()),
            section_.column + 0.5,
            section_.rows.local(0.0),
            section_.rows.speed(),
            extension};
}

double RevolutionWalk::stepHere(const ShapeCell& cell) const noexcept {
    if (!solid_->shape->isCreased())
        return sectionCell(cell.a, 0.0).value(entry_);
    const int width = solid_->shape->width();
    return sectionCell(reference::stepCell(*solid_->shape,
                                           wrapIndex(section_.column, width, WrapMode::Clamp),
                                           wrapIndex(section_.column + 1, width, WrapMode::Clamp),
                                           section_.rows.low(), section_.rows.high()),
                       0.0)
        .value(entry_);
}

// The field that is the distance between two creases.
const BilinearCell& RevolutionWalk::fieldBetween(const ShapeCell& cell, double from,
                                                 double to) const noexcept {
    return cell.isCreased() ? cell.at(sectionCell(cell.a, 0.0).place(0.5 * (from + to))) : cell.a;
}

glm::dvec3 RevolutionWalk::flatOutward(int axis) const noexcept {
    glm::dvec3 outward(0.0);
    // Against the ray where it enters, with it where it leaves.
    outward[axis] = (span_.direction[axis] > 0.0) == isInside_ ? 1.0 : -1.0;
    return outward;
}

glm::dvec3 RevolutionWalk::wallOutward(const SectionCell& cell, double t) const noexcept {
    const glm::dvec2 perTexel = cell.cell.gradient(cell.place(t));
    const glm::dvec2 radial = section_.start + t * glm::dvec2(span_.direction);
    const double radius = std::hypot(radial.x, radial.y);
    const glm::dvec2 away = radius > 0.0 ? radial / radius : glm::dvec2(0.0);
    return {perTexel.x * cell.texels * away, section_.sign * perTexel.y * solid_->shape->height()};
}

void RevolutionWalk::toggle(double t, SolidFace face, const glm::dvec3& outward) {
    isInside_ = !isInside_;
    pending_.push_back({t, isInside_, face, outward});
}

// A change at the entry of a cell: at the border of the window or of a replica, or by a rounding
// by which two cells disagree.
void RevolutionWalk::toggleAtBorder(const SectionCell& cell) {
    const int axis = isAtStart_ ? span_.entryAxis : borderAxis_;
    const double t = replicaEntry_ + entry_;
    if (axis >= 0)
        toggle(t, SolidFace::Cap, flatOutward(axis));
    else if (isAtStart_ && cell.value(entry_) < 0.0)
        toggle(t, SolidFace::Origin, glm::dvec3(0.0));
    else
        toggle(t, SolidFace::Wall, wallOutward(cell, entry_));
}

void RevolutionWalk::cross(const SectionCell& cell, double from, double to) {
    if (cell.isInside(from) != isInside_)  // two fields disagree by a rounding
        toggle(replicaEntry_ + from, SolidFace::Wall, wallOutward(cell, from));
    if (cell.cell.minimum > solid_->extension)
        return;
    places_.clear();
    appendSignChanges(cell, from, to, places_);
    for (const double t : places_)
        toggle(replicaEntry_ + t, SolidFace::Wall, wallOutward(cell, t));
}

void RevolutionWalk::cross(const ShapeCell& cell) {
    creases_.clear();
    if (cell.isCreased())
        appendSignChanges(sectionCell(cell.difference(), 0.0), entry_, exit_, creases_);
    creases_.push_back(exit_);
    double from = entry_;
    for (const double to : creases_) {
        cross(sectionCell(fieldBetween(cell, from, to), solid_->extension), from, to);
        from = to;
    }
}

void RevolutionWalk::walkOn() {
    const int width = solid_->shape->width();
    const ShapeCell cell =
        reference::shapeCell(*solid_->shape, wrapIndex(section_.column, width, WrapMode::Clamp),
                             wrapIndex(section_.column + 1, width, WrapMode::Clamp),
                             section_.rows.low(), section_.rows.high());
    const SectionCell here = sectionCell(fieldBetween(cell, entry_, entry_), solid_->extension);
    if (here.isInside(entry_) != isInside_)
        toggleAtBorder(here);
    isAtStart_ = false;
    borderAxis_ = -1;
    if (jump(stepHere(cell))) {
        if (cost_ != nullptr)
            ++cost_->jumps;
        if (entry_ >= section_.end)
            leaveReplica();
        return;
    }
    cross(cell);
    if (cost_ != nullptr)
        ++cost_->cells;
    if (exit_ >= section_.end)
        leaveReplica();
    else
        step();
}

}  // namespace relievo::solids
