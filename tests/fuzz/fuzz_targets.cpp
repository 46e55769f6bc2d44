#include "tests/fuzz/fuzz_targets.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "textures/height_image.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "textures/map_metadata.h"

namespace relievo::textures {
namespace {

void require(bool holds, const char* promise) {
    if (holds)
        return;
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
}

// OpenImageIO tries the reader of the extension first.
std::string extensionOf(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG"))
        return ".png";
    return bytes.starts_with("II") || bytes.starts_with("MM") ? ".tif" : ".exr";
}

// A file of this process in memory, if the system has such a folder.
std::filesystem::path fileFor(std::string_view bytes) {
    const std::filesystem::path memory = "/dev/shm";
    const std::filesystem::path folder =
        std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    return folder / ("relievo-fuzz-" + std::to_string(::getpid()) + extensionOf(bytes));
}

void checkMaps(const MapSet& maps) {
    require(maps.width() > 0 && maps.height() > 0, "a map file has texels");
    for (const Channel& channel : maps.channels) {
        const Plane& plane = channel.plane;
        require(plane.width == maps.width() && plane.height == maps.height(), "one size");
        require(plane.texels.size() ==
                    static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height),
                "as many texels as the size says");
        for (const float value : plane.texels)
            require(std::isfinite(value), "finite values");
    }
}

}  // namespace

void fuzzMapFile(std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::filesystem::path file = fileFor(text);
    std::ofstream(file, std::ios::binary) << text;
    try {
        checkMaps(readMapFile(file));
    } catch (const InputError&) {
    }
    try {
        for (const float depth : readHeightImage(file, {}).depth.depth.texels)
            require(depth >= 0.0f && depth <= 1.0f, "depths from 0 to 1");
    } catch (const InputError&) {
    }
    std::filesystem::remove(file);
}

void fuzzMetadata(std::span<const std::uint8_t> bytes) {
    TextAttributes attributes;
    std::istringstream stream(
        std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    for (std::string line; std::getline(stream, line);)
        if (const std::size_t equals = line.find('='); equals != std::string::npos)
            attributes["relievo:" + line.substr(0, equals)] = line.substr(equals + 1);
    try {
        const MapSet maps = mapsFromAttributes(attributes, "file");
        const std::vector<std::string> layout = layoutFromAttributes(attributes, "file");
        const ChannelRanges ranges = rangesFromAttributes(attributes, "file");
        for (const auto& [name, range] : ranges)
            require(range.low < range.high && std::isfinite(range.high - range.low),
                    "ranges grow and have a length");
        const TextAttributes again = describeMaps(maps, layout, ranges);
        require(rangesFromAttributes(again, "file").size() == ranges.size(),
                "all ranges come back");
        require(mapsFromAttributes(again, "file").attributes == maps.attributes,
                "all attributes come back");
    } catch (const InputError&) {
    }
}

}  // namespace relievo::textures
