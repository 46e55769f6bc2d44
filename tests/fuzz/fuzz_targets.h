#pragma once

#include <cstdint>
#include <span>

namespace relievo::textures {

/// Reads `bytes` as a map file and as a height image. Whatever they are, the answer is maps that
/// keep their promises or an InputError; anything else ends the process.
void fuzzMapFile(std::span<const std::uint8_t> bytes);

/// Reads `bytes` as the attributes of a map file, one `name=value` a line, with the same promise.
void fuzzMetadata(std::span<const std::uint8_t> bytes);

}  // namespace relievo::textures
