#include "solids/solid_texturing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "textures/input_error.h"

namespace relievo::solids {
namespace {

constexpr std::array<std::string_view, 6> kNames{"planar-z",    "planar-y",  "planar-diagonal",
                                                 "cylindrical", "spherical", "box"};

}  // namespace

std::string_view solidTexturingName(SolidTexturing texturing) noexcept {
    return kNames[static_cast<std::size_t>(texturing)];
}

SolidTexturing findSolidTexturing(std::string_view name) {
    const auto found = std::ranges::find(kNames, name);
    if (found == kNames.end())
        throw textures::InputError(fmt::format("there is no texturing \"{}\", expected {}", name,
                                               fmt::join(kNames, ", ")));
    return static_cast<SolidTexturing>(found - kNames.begin());
}

}  // namespace relievo::solids
