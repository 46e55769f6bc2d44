#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace relievo::tests {

/// Whether a map file of a test has the channel that cone tracing needs.
enum class ConeChannel { Present, Missing };

/// Writes the maps of a sample relief (textures/sample_reliefs.h) of `width`×`height` texels as a
/// float EXR.
void writeSampleMaps(const std::filesystem::path& file, std::string_view sample, int width,
                     int height, ConeChannel cones = ConeChannel::Present);

}  // namespace relievo::tests
