#include "solids/profile.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "textures/input_error.h"

namespace relievo::solids {
namespace {

struct NamedShape {
    std::string_view name;
    ProfileShape shape;
};
constexpr std::array kShapes{
    NamedShape{"bevel", ProfileShape::Bevel}, NamedShape{"round", ProfileShape::Round},
    NamedShape{"cove", ProfileShape::Cove}, NamedShape{"ogee", ProfileShape::Ogee}};

// A point of a profile of unit depth and bevel, with its normal.
struct UnitKnot {
    glm::dvec2 place;   // depth, offset
    glm::dvec2 normal;  // of the outline's direction, of the vertical
};

// From the level start of a quarter circle to its upright end.
UnitKnot roundKnot(double share) {
    const double angle = 0.5 * std::numbers::pi * share;
    return {{1.0 - std::cos(angle), std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
}

// From the upright start of a hollow to its level end.
UnitKnot coveKnot(double share) {
    const double angle = 0.5 * std::numbers::pi * share;
    return {{std::sin(angle), 1.0 - std::cos(angle)}, {std::cos(angle), std::sin(angle)}};
}

// Half of each, of half the size.
UnitKnot halved(UnitKnot knot, double start) {
    knot.place = glm::dvec2(start) + 0.5 * knot.place;
    return knot;
}

std::vector<UnitKnot> unitKnots(ProfileShape shape) {
    std::vector<UnitKnot> knots;
    const auto append = [&](const auto& knotAt) {
        for (int k = 0; k <= kRoundPieces; ++k)
            knots.push_back(knotAt(static_cast<double>(k) / kRoundPieces));
    };
    switch (shape) {
        case ProfileShape::Round:
            append(roundKnot);
            break;
        case ProfileShape::Cove:
            append(coveKnot);
            break;
        case ProfileShape::Ogee:
            append([](double share) { return halved(coveKnot(share), 0.0); });
            knots.pop_back();  // the round half begins where the hollow one ends
            append([](double share) { return halved(roundKnot(share), 0.5); });
            break;
        case ProfileShape::Bevel:
            knots = {{{0.0, 0.0}, {1.0, 1.0}}, {{1.0, 1.0}, {1.0, 1.0}}};
            break;
    }
    return knots;
}

ProfilePiece straightPiece(double top, double bottom, double topOffset, double bottomOffset) {
    ProfilePiece piece{top, bottom, topOffset, bottomOffset, {}, {}};
    piece.topNormal = piece.bottomNormal = {1.0, piece.slope()};
    return piece;
}

}  // namespace

std::string_view profileShapeName(ProfileShape shape) noexcept {
    for (const NamedShape& known : kShapes)
        if (known.shape == shape)
            return known.name;
    return "";
}

ProfileShape findProfileShape(std::string_view name) {
    std::vector<std::string_view> names;
    for (const NamedShape& known : kShapes) {
        if (known.name == name)
            return known.shape;
        names.push_back(known.name);
    }
    throw textures::InputError(
        fmt::format("there is no profile \"{}\", expected {}", name, fmt::join(names, ", ")));
}

Profile makeProfile(double extension, double bevel, double chamfer, ProfileShape shape) {
    assert(chamfer >= 0.0 && chamfer <= 1.0);
    if (bevel == 0.0 || chamfer == 0.0)
        return {{straightPiece(0.0, 1.0, extension + bevel, extension + bevel)}};
    Profile profile;
    const std::vector<UnitKnot> knots = unitKnots(shape);
    // The normal of the stretched curve: (b·x, c·y) has (x/b, y/c), or c·x and b·y.
    const glm::dvec2 stretch(chamfer, bevel);
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
        const UnitKnot& a = knots[k];
        const UnitKnot& b = knots[k + 1];
        profile.pieces.push_back({chamfer * a.place.x, chamfer * b.place.x,
                                  extension + bevel * a.place.y, extension + bevel * b.place.y,
                                  stretch * a.normal, stretch * b.normal});
    }
    profile.pieces.back().bottom = chamfer;
    if (chamfer < 1.0)
        profile.pieces.push_back(straightPiece(chamfer, 1.0, extension + bevel, extension + bevel));
    return profile;
}

Profile profileThrough(std::span<const glm::dvec2> knots) {
    if (knots.empty())
        throw textures::InputError(
            "a profile without knots, expected at least one depth and offset");
    double last = 0.0;
    for (const glm::dvec2& knot : knots) {
        if (!std::isfinite(knot.x) || !std::isfinite(knot.y) || knot.x < last || knot.x > 1.0)
            throw textures::InputError(
                fmt::format("the profile's knot ({}, {}): expected depths from 0 to 1 in order, "
                            "and offsets that "
                            "are numbers",
                            knot.x, knot.y));
        last = knot.x;
    }
    std::vector<glm::dvec2> all(knots.begin(), knots.end());
    all.insert(all.begin(), {0.0, all.front().y});
    all.push_back({1.0, all.back().y});
    Profile profile;
    for (std::size_t k = 0; k + 1 < all.size(); ++k)
        if (all[k].x < all[k + 1].x)
            profile.pieces.push_back(straightPiece(all[k].x, all[k + 1].x, all[k].y, all[k + 1].y));
    if (profile.pieces.size() > static_cast<std::size_t>(kMostPieces))
        throw textures::InputError(fmt::format("a profile of {} pieces, expected at most {}",
                                               profile.pieces.size(), kMostPieces));
    return profile;
}

double offsetAt(const Profile& profile, double z) {
    for (const ProfilePiece& piece : profile.pieces)
        if (z < piece.bottom)
            return piece.offset(z);
    return profile.pieces.back().offset(z);
}

double largestOffset(const Profile& profile) {
    double largest = profile.pieces.front().topOffset;
    for (const ProfilePiece& piece : profile.pieces)
        largest = std::max({largest, piece.topOffset, piece.bottomOffset});
    return largest;
}

}  // namespace relievo::solids
