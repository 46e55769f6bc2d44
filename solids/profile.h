#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace relievo::solids {

/// A straight piece of a profile, between two depths.
struct ProfilePiece {
    double top = 0.0;           ///< normalised depth where it begins
    double bottom = 1.0;        ///< where it ends, > top
    double topOffset = 0.0;     ///< offset at `top`, in tile widths
    double bottomOffset = 0.0;  ///< offset at `bottom`
    /// What the normal has of the outline's direction (x) and of the upward vertical (y, per unit
    /// of normalised depth) at both ends, of any length: (1, slope) where the profile is straight,
    /// (0,1) where a round one begins level. Shading goes evenly from the one to the other.
    glm::dvec2 topNormal{1.0, 0.0};
    glm::dvec2 bottomNormal{1.0, 0.0};

    /// Of the offset over the depth.
    [[nodiscard]] double slope() const noexcept {
        return (bottomOffset - topOffset) / (bottom - top);
    }
    [[nodiscard]] double offset(double z) const noexcept { return topOffset + slope() * (z - top); }
};

/// How far an extruded solid reaches from the outline of its shape, for every depth from 0 to 1:
/// the offset o(z) in tile widths. Pieces follow each other without gaps; where one begins with
/// another offset than the one before ends with there is a level step.
///
/// Round profiles are inscribed polylines: the solid is exactly what the pieces say, and nowhere
/// further from the round one than kRoundPieces allows.
struct Profile {
    std::vector<ProfilePiece> pieces;

    friend bool operator==(const Profile&, const Profile&) = default;
};

/// Pieces that shaders have room for.
inline constexpr int kMostPieces = 32;
/// Pieces of a quarter of an ellipse: the chords are at most 1 − cos(π/48) = 0.0022 of the bevel
/// from it.
inline constexpr int kRoundPieces = 12;

/// The shapes of profiles (specification 7.2): e, b and c in o(z) = e + b·s(z/c) with s(1) = 1 from
/// there on.
enum class ProfileShape {
    Bevel,  ///< straight: s(x) = x; a chamfer when c < 1
    Round,  ///< a quarter of an ellipse, level at the top: s(x) = √(1 − (1−x)²)
    Cove,   ///< hollow, level at the end: s(x) = 1 − √(1 − x²)
    Ogee,   ///< hollow, then round: an S
};

/// "bevel", "round", "cove", "ogee": the words of command lines and scene files.
std::string_view profileShapeName(ProfileShape shape) noexcept;
/// The shape of that name. Throws textures::InputError, listing the names.
ProfileShape findProfileShape(std::string_view name);

/// The profile of extension e and bevel b (tile widths, of any sign) down to depth c in [0,1], and
/// straight from there. With b = 0 or c = 0 it is one piece (for c = 0 of the offset e + b).
Profile makeProfile(double extension, double bevel = 0.0, double chamfer = 1.0,
                    ProfileShape shape = ProfileShape::Bevel);

/// The profile through (z, offset) knots: from the first to the last straight from knot to knot,
/// and as far as the outer ones before and after. Two knots of one z make a level step. Throws
/// textures::InputError for no knots, for more than kMostPieces pieces, and for depths that are not
/// in [0,1] and in order, or numbers that are not finite.
Profile profileThrough(std::span<const glm::dvec2> knots);

/// o(z), z in [0,1]; at a step that of the piece below it.
double offsetAt(const Profile& profile, double z);

/// The largest offset of the profile.
double largestOffset(const Profile& profile);

}  // namespace relievo::solids
