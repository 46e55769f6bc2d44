#pragma once

#include <optional>
#include <string_view>

namespace relievo::textures {

/// What a map file holds of a cone: its ratio (horizontal distance per unit of depth); the radius
/// at the reference surface, ratio·D; or, in packed files, the square root of the ratio, which
/// gives narrow cones more of the codes. In memory the channel holds ratios for Sqrt too: the root
/// is a matter of the file alone. Ratios of roof cones are Ratio or Sqrt.
enum class ConeEncoding { Ratio, Radius, Sqrt };

/// "ratio", "radius" or "sqrt": the words of the command line and of `relievo:encoding`.
constexpr std::string_view coneEncodingName(ConeEncoding encoding) noexcept {
    switch (encoding) {
        case ConeEncoding::Ratio:
            return "ratio";
        case ConeEncoding::Radius:
            return "radius";
        case ConeEncoding::Sqrt:
            break;
    }
    return "sqrt";
}

/// The inverse of coneEncodingName; nothing for any other word.
constexpr std::optional<ConeEncoding> coneEncodingFromName(std::string_view name) noexcept {
    for (const ConeEncoding encoding :
         {ConeEncoding::Ratio, ConeEncoding::Radius, ConeEncoding::Sqrt})
        if (coneEncodingName(encoding) == name)
            return encoding;
    return std::nullopt;
}

}  // namespace relievo::textures
