#include "solids/extrusion_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "reference/bilinear_cell.h"
#include "solids/line_roots.h"

namespace relievo::solids {
namespace {

using reference::BilinearCell;

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
double ExtrusionWalk::freeUntil(double distance, double clearance) const noexcept {
    const double radius = freeSpace_->radius(distance, lowestOffset_, highestOffset_);
    const double whole =
        radius > 0.0 ? (texelSpeed_ > 0.0 ? entry_ + radius / texelSpeed_ : kInfinity) : entry_;
    // Or in this piece of the profile.
    const double sign = clearance > 0.0 ? 1.0 : -1.0;
    const double inPiece = freeSpace_->duration(
        distance, sign * clearance, sign * piece().slope() * span_.direction.z, texelSpeed_);
    return std::max(whole, std::min(entry_ + inPiece, pieceExit_));
}

// Over free space, if that leads out of the cell.
bool ExtrusionWalk::jump(double distance, double clearance) noexcept {
    if (freeSpace_ == nullptr)
        return false;
    const double target = freeUntil(distance, clearance);
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

void ExtrusionWalk::walkOn() {
    const textures::Plane& d = solid_->shape->distance;
    const BilinearCell cell(d.at(columns_.low(), rows_.low()), d.at(columns_.high(), rows_.low()),
                            d.at(columns_.low(), rows_.high()),
                            d.at(columns_.high(), rows_.high()));
    const glm::dvec2 place(columns_.local(entry_), rows_.local(entry_));
    const glm::dvec2 speed(columns_.speed(), rows_.speed());
    const double distance = cell.depth(place);
    const Quadratic clearance{
        distance - piece().offset(z(entry_)),
        glm::dot(cell.gradient(place), speed) - piece().slope() * span_.direction.z,
        cell.twist * speed.x * speed.y};
    if (clearance.beginsInside() != isInside_) {
        const SolidFace face = borderFace(clearance.constant);
        toggle(entry_, face, outwardAt(face, cell, entry_));
    }
    if (jump(distance, clearance.constant)) {
        if (cost_ != nullptr)
            ++cost_->jumps;
        if (entry_ >= span_.end)
            finish();
        return;
    }
    if (cell.minimum <= std::max(piece().topOffset, piece().bottomOffset)) {
        const SignChanges changes = signChanges(clearance, exit_ - entry_);
        for (int k = 0; k < changes.count; ++k) {
            const double t = entry_ + changes.places[static_cast<std::size_t>(k)];
            toggle(t, SolidFace::Wall, outwardAt(SolidFace::Wall, cell, t));
        }
    }
    if (cost_ != nullptr)
        ++cost_->cells;
    if (exit_ >= span_.end)
        finish();
    else
        step();
}

// Of the crossing that is about to happen at t in the current cell.
glm::dvec3 ExtrusionWalk::outwardAt(SolidFace face, const BilinearCell& cell, double t) const {
    switch (face) {
        case SolidFace::Wall: {
            const glm::dvec2 perTexel = cell.gradient({columns_.local(t), rows_.local(t)});
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
