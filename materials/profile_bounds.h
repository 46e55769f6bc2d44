#pragma once

#include <array>
#include <vector>

#include "solids/profile.h"

namespace relievo::materials {

/// The ways in which rays look at a profile, in the order of the components of SolidPiece in
/// shaders/relievo/solid/block.glsl: down and up from outside, down and up from inside.
inline constexpr int kProfileWays = 4;

/// How a profile may come nearer to a ray on its way, from one of its pieces on. Offsets are those
/// of the profile from outside and their negatives from inside.
struct ProfileBounds {
    std::array<double, kProfileWays> chord;  ///< largest growth of the offset per unit of depth
                                             ///< from a place of the piece to any one up to `limit`
    std::array<double, kProfileWays> extreme;  ///< largest offset anywhere on the way
    std::array<double, kProfileWays> limit;    ///< depth of the next level step that comes nearer;
                                               ///< 2 (down) or −1 (up): there is none
};

/// The bounds of each piece, in the order of the pieces.
std::vector<ProfileBounds> profileBounds(const solids::Profile& profile);

}  // namespace relievo::materials
