#include "textures/channel_rules.h"

#include <array>

namespace relievo::textures {

namespace {

struct NamedRule {
    std::string_view name;
    ChannelRule rule;
};

constexpr ChannelRule kUnit{Rounding::Nearest, false, true};
constexpr ChannelRule kSigned{Rounding::Nearest, true, false};
constexpr ChannelRule kSafe{Rounding::Down, false, false};
constexpr ChannelRule kCone{Rounding::Down, false, false, true};
constexpr ChannelRule kSafeUnit{Rounding::Down, false, true};
// Distances, and −1 where there is none; and what steps along a shape map go by.
constexpr ChannelRule kSafeOrNone{Rounding::Down, true, false};
// Distances to an outline: outside > 0, inside < 0.
constexpr ChannelRule kDistance{Rounding::TowardsZero, true, false};

/// Cones may have a layer per sector: `cone0`, `roof0`, `ratio0` … follow the rule of the name.
constexpr std::array kRules{
    NamedRule{"depth", kUnit},  NamedRule{"dx", kSigned},       NamedRule{"dy", kSigned},
    NamedRule{"nx", kSigned},   NamedRule{"ny", kSigned},       NamedRule{"nz", kSigned},
    NamedRule{"cone", kCone},   NamedRule{"ratio", kCone},      NamedRule{"roof", kSafeUnit},
    NamedRule{"volume", kSafe}, NamedRule{"cylinder", kSafe},   NamedRule{"occlusion", kUnit},
    NamedRule{"dmin", kUnit},   NamedRule{"dmax", kUnit},       NamedRule{"vdm", kSafeOrNone},
    NamedRule{"gx", kSigned},   NamedRule{"gy", kSigned},       NamedRule{"distance", kDistance},
    NamedRule{"shape", kUnit},  NamedRule{"step", kSafeOrNone},
};

}  // namespace

ChannelRule channelRule(std::string_view name) noexcept {
    const std::size_t letters = name.find_last_not_of("0123456789") + 1;
    for (const NamedRule& known : kRules)
        if (known.name == name.substr(0, letters))
            return known.rule;
    return kSigned;
}

}  // namespace relievo::textures
