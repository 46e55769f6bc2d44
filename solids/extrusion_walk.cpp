#include "solids/extrusion_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace relievo::solids {
namespace {

using reference::BilinearCell;
using reference::ShapeCell;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The piece that a ray is in which begins at depth z.
std::size_t firstPiece(const Profile& profile, double z, double speed) {
    std::size_t k = 0;
    while (k + 1 < profile.pieces.size() &&
           (speed < 0.0 ? z > profile.pieces[k].bottom : z >= profile.pieces[k].bottom))
        ++k;
    return k;
}

}  // namespace

ExtrusionWalk::ExtrusionWalk(const Solid& solid, const FreeSpace* freeSpace, const WalkSpan& span,
                             TraceCost* cost)
    : solid_(&solid),
      freeSpace_(freeSpace),
      span_(span),
      cost_(cost),
      columns_(span.start.x * solid.shape->width() - 0.5, span.direction.x * solid.shape->width(),
               solid.shape->width(), solid.shape->wrap),
      rows_(span.start.y * solid.shape->height() - 0.5, span.direction.y * solid.shape->height(),
            solid.shape->height(), solid.shape->wrap),
      texelSpeed_(std::hypot(columns_.speed(), rows_.speed())),
      piece_(firstPiece(solid.profile, span.start.z, span.direction.z)),
      columnExit_(columns_.exit()),
      rowExit_(rows_.exit()) {
    lowestOffset_ = kInfinity;
    highestOffset_ = -kInfinity;
    for (const ProfilePiece& p : solid.profile.pieces) {
        lowestOffset_ = std::min({lowestOffset_, p.topOffset, p.bottomOffset});
        highestOffset_ = std::max({highestOffset_, p.topOffset, p.bottomOffset});
    }
    findPieceExit();
    findExit();
}

std::optional<SolidCrossing> ExtrusionWalk::next() {
    while (firstPending_ == pendingCount_) {
        if (isDone_)
            return std::nullopt;
        firstPending_ = pendingCount_ = 0;
        walkOn();
    }
    return pending_[firstPending_++];
}

void ExtrusionWalk::stepPiece() noexcept {
    const ProfilePiece& before = piece();
    const bool down = span_.direction.z > 0.0;
    piece_ = down ? piece_ + 1 : piece_ - 1;
    border_ = Border::Piece;
    stepAtBorder_ =
        down ? before.bottomOffset != piece().topOffset : before.topOffset != piece().bottomOffset;
    findPieceExit();
}

void ExtrusionWalk::findPieceExit() noexcept {
    const double speed = span_.direction.z;
    const bool isLast =
        speed == 0.0 || (speed > 0.0 ? piece_ + 1 == solid_->profile.pieces.size() : piece_ == 0);
    pieceExit_ =
        isLast ? kInfinity : ((speed > 0.0 ? piece().bottom : piece().top) - span_.start.z) / speed;
}

// Borders met at once may swap by a rounding; the parameter must not go back for it.
void ExtrusionWalk::findExit() noexcept {
    exit_ = std::max(entry_, std::min({columnExit_, rowExit_, pieceExit_, span_.end}));
}

void ExtrusionWalk::step() noexcept {
    entry_ = exit_;
    border_ = Border::Cell;
    if (pieceExit_ <= columnExit_ && pieceExit_ <= rowExit_) {
        stepPiece();
    } else if (columnExit_ <= rowExit_) {
        columns_.step();
        columnExit_ = columns_.exit();
    } else {
        rows_.step();
        rowExit_ = rows_.exit();
    }
    findExit();
}

// How far the ray is free from the entry on: all outside or all inside.
double ExtrusionWalk::freeUntil(double step) const noexcept {
    const double radius = freeSpace_->radius(step, lowestOffset_, highestOffset_);
    const double whole =
        radius > 0.0 ? (texelSpeed_ > 0.0 ? entry_ + radius / texelSpeed_ : kInfinity) : entry_;
    // Or in this piece of the profile.
    const double outside = step - piece().offset(z(entry_));
    const double inside = -(outside + freeSpace_->creaseDepth());
    const double sign = outside > 0.0 ? 1.0 : -1.0;
    const double inPiece = freeSpace_->duration(
        step, std::max(outside, inside), sign * piece().slope() * span_.direction.z, texelSpeed_);
    return std::max(whole, std::min(entry_ + inPiece, pieceExit_));
}

// Over free space, if that leads out of the cell.
bool ExtrusionWalk::jump(double step) noexcept {
    const double target = freeUntil(step);
    if (!(target > exit_))
        return false;
    entry_ = std::min(target, span_.end);
    border_ = Border::Cell;
    if (entry_ < span_.end) {
        columns_.jump(entry_);
        rows_.jump(entry_);
        columnExit_ = columns_.exit();
        rowExit_ = rows_.exit();
        while (pieceExit_ <= entry_)
            stepPiece();
    }
    findExit();
    return true;
}

glm::dvec3 ExtrusionWalk::flatOutward(int axis) const noexcept {
    glm::dvec3 outward(0.0);
    // Against the ray where it enters, with it where it leaves.
    outward[axis] = (span_.direction[axis] > 0.0) == isInside_ ? 1.0 : -1.0;
    return outward;
}

void ExtrusionWalk::toggle(double t, SolidFace face, const glm::dvec3& outward) noexcept {
    isInside_ = !isInside_;
    pending_[pendingCount_++] = {t, isInside_, face, outward};
}

// Of a change at the entry, where the implicit function has that value.
SolidFace ExtrusionWalk::borderFace(double value) const noexcept {
    if (border_ == Border::Piece && stepAtBorder_)
        return SolidFace::Step;
    if (border_ != Border::Start)
        return SolidFace::Wall;  // two cells disagree by a rounding
    if (span_.entryAxis >= 0)
        return SolidFace::Cap;
    return value < 0.0 ? SolidFace::Origin : SolidFace::Wall;
}

// At the end of the span, where it leaves the window.
void ExtrusionWalk::finish() noexcept {
    isDone_ = true;
    if (isInside_ && span_.exitAxis >= 0)
        toggle(span_.end, SolidFace::Cap, flatOutward(span_.exitAxis));
}

// d − o of a field of the cell from t on.
Quadratic ExtrusionWalk::clearance(const BilinearCell& field, double t) const {
    const glm::dvec2 speed(columns_.speed(), rows_.speed());
    return {field.depth(place(t)) - piece().offset(z(t)),
            glm::dot(field.gradient(place(t)), speed) - piece().slope() * span_.direction.z,
            field.twist * speed.x * speed.y};
}

// What is different from what was before the cell.
void ExtrusionWalk::enter(const ShapeCell& cell) {
    const BilinearCell& field = cell.at(place(entry_));
    const Quadratic here = clearance(field, entry_);
    if (here.beginsInside() == isInside_)
        return;
    const SolidFace face = borderFace(here.constant);
    toggle(entry_, face, outwardAt(face, field, entry_));
}

bool ExtrusionWalk::jumpFrom(const ShapeCell& cell) {
    if (freeSpace_ == nullptr)
        return false;
    if (!solid_->shape->isCreased())
        return jump(cell.a.depth(place(entry_)));
    return jump(reference::stepCell(*solid_->shape, columns_.low(), columns_.high(), rows_.low(),
                                    rows_.high())
                    .depth(place(entry_)));
}

// Between creases, where one field is the distance.
void ExtrusionWalk::cross(const BilinearCell& field, double from, double to) {
    const Quadratic here = clearance(field, from);
    if (here.beginsInside() != isInside_)  // two fields disagree by a rounding
        toggle(from, SolidFace::Wall, outwardAt(SolidFace::Wall, field, from));
    if (field.minimum > std::max(piece().topOffset, piece().bottomOffset))
        return;
    const SignChanges changes = signChanges(here, to - from);
    for (int k = 0; k < changes.count; ++k) {
        const double t = from + changes.places[static_cast<std::size_t>(k)];
        toggle(t, SolidFace::Wall, outwardAt(SolidFace::Wall, field, t));
    }
}

void ExtrusionWalk::cross(const ShapeCell& cell) {
    if (!cell.isCreased()) {
        cross(cell.a, entry_, exit_);
        return;
    }
    const Quadratic a = clearance(cell.a, entry_);
    const Quadratic b = clearance(cell.b, entry_);
    const SignChanges creases = signChanges(
        {a.constant - b.constant, a.linear - b.linear, a.quadratic - b.quadratic}, exit_ - entry_);
    double from = entry_;
    for (int k = 0; k <= creases.count; ++k) {
        const double to =
            k < creases.count ? entry_ + creases.places[static_cast<std::size_t>(k)] : exit_;
        cross(cell.at(place(0.5 * (from + to))), from, to);
        from = to;
    }
}

void ExtrusionWalk::walkOn() {
    const ShapeCell cell = reference::shapeCell(*solid_->shape, columns_.low(), columns_.high(),
                                                rows_.low(), rows_.high());
    enter(cell);
    if (jumpFrom(cell)) {
        if (cost_ != nullptr)
            ++cost_->jumps;
        if (entry_ >= span_.end)
            finish();
        return;
    }
    cross(cell);
    if (cost_ != nullptr)
        ++cost_->cells;
    if (exit_ >= span_.end)
        finish();
    else
        step();
}

// Of the crossing that is about to happen at t in the current cell.
glm::dvec3 ExtrusionWalk::outwardAt(SolidFace face, const BilinearCell& field, double t) const {
    switch (face) {
        case SolidFace::Wall: {
            const glm::dvec2 perTexel = field.gradient(place(t));
            return {perTexel.x * solid_->shape->width(), perTexel.y * solid_->shape->height(),
                    -piece().slope()};
        }
        case SolidFace::Step:
            return flatOutward(2);
        case SolidFace::Cap:
            return flatOutward(span_.entryAxis);
        case SolidFace::Origin:
            break;
    }
    return glm::dvec3(0.0);
}

}  // namespace relievo::solids
