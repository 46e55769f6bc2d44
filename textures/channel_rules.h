#pragma once

#include <string_view>

namespace relievo::textures {

/// Which way a stored value may leave the true one: a cone that is too wide lets a ray pass the
/// surface, one that is too narrow only costs steps. Likewise distances of either sign, which are
/// safe as long as they are not farther from 0 than true.
enum class Rounding { Nearest, Down, TowardsZero };

/// How the values of a channel are stored.
struct ChannelRule {
    Rounding rounding = Rounding::Nearest;
    bool isSigned = false;     ///< has values of both signs, and 0 must come back as exactly 0
    bool isUnitRange = false;  ///< lies in [0,1] by definition
    bool isCone = false;       ///< is the width of a cone, in a ConeEncoding
};

/// The rule of the channel called `name`; names that the specification does not list are rounded to
/// the nearest value and may have either sign.
ChannelRule channelRule(std::string_view name) noexcept;

}  // namespace relievo::textures
