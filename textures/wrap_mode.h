#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace relievo::textures {

/// How a map continues outside its tile [0,1]². The values match GL_REPEAT, GL_MIRRORED_REPEAT and
/// GL_CLAMP_TO_EDGE.
enum class WrapMode { Repeat, Mirror, Clamp };

/// The texel in [0,size) that stands for texel `index` (any integer) of an axis with `size` ≥ 1
/// texels.
constexpr int wrapIndex(std::int64_t index, int size, WrapMode mode) noexcept {
    const std::int64_t n = size;
    if (index >= 0 && index < n)  // nearly always, and a division is slow
        return static_cast<int>(index);
    switch (mode) {
        case WrapMode::Repeat: {
            const std::int64_t r = index % n;
            return static_cast<int>(r < 0 ? r + n : r);
        }
        case WrapMode::Mirror: {
            std::int64_t r = index % (2 * n);
            r = r < 0 ? r + 2 * n : r;
            return static_cast<int>(r < n ? r : 2 * n - 1 - r);
        }
        case WrapMode::Clamp:
            break;
    }
    return static_cast<int>(index < 0 ? 0 : (index >= n ? n - 1 : index));
}

/// "repeat", "mirror" or "clamp": the words of the command line and of `relievo:wrap`.
constexpr std::string_view wrapModeName(WrapMode mode) noexcept {
    switch (mode) {
        case WrapMode::Repeat:
            return "repeat";
        case WrapMode::Mirror:
            return "mirror";
        case WrapMode::Clamp:
            break;
    }
    return "clamp";
}

/// The inverse of wrapModeName; nothing for any other word.
constexpr std::optional<WrapMode> wrapModeFromName(std::string_view name) noexcept {
    for (const WrapMode mode : {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp})
        if (wrapModeName(mode) == name)
            return mode;
    return std::nullopt;
}

}  // namespace relievo::textures
