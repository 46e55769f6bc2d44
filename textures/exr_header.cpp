#include "textures/exr_header.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace relievo::textures {

namespace {

constexpr std::string_view kMagic = "\x76\x2F\x31\x01";
constexpr std::uint32_t kMultiPart = 1u << 12;
constexpr std::int64_t kLargestTile = 1 << 24;
constexpr std::size_t kLongestName = 255;

const std::string kTruncated = "is truncated or damaged in its header, expected a whole image";

/// Little-endian, as everything in EXR; zeros behind the end of the file.
template <std::size_t kCount>
std::array<std::uint32_t, kCount> readWords(std::istream& stream) {
    std::array<std::uint32_t, kCount> words{};
    for (std::uint32_t& word : words)
        for (int shift = 0; shift < 32; shift += 8)
            word |= (static_cast<std::uint32_t>(stream.get()) & 0xFFu) << shift;
    return words;
}

/// Up to the zero that ends it; the stream fails when there is none.
std::string readName(std::istream& stream) {
    std::string name;
    for (int letter = stream.get(); letter != 0; letter = stream.get()) {
        if (!stream || name.size() == kLongestName) {
            stream.setstate(std::ios::failbit);
            break;
        }
        name.push_back(static_cast<char>(letter));
    }
    return name;
}

struct TypeLength {
    std::string_view type;
    std::int64_t length;
};

/// Of these the library reads so many bytes, whatever length the file gives: the rest would be
/// taken for the next attribute.
constexpr std::array kLengths{
    TypeLength{"box2f", 16},
    TypeLength{"box2i", 16},
    TypeLength{"chromaticities", 32},
    TypeLength{"compression", 1},
    TypeLength{"deepImageState", 1},
    TypeLength{"double", 8},
    TypeLength{"envmap", 1},
    TypeLength{"float", 4},
    TypeLength{"int", 4},
    TypeLength{"keycode", 28},
    TypeLength{"lineOrder", 1},
    TypeLength{"m33d", 72},
    TypeLength{"m33f", 36},
    TypeLength{"m44d", 128},
    TypeLength{"m44f", 64},
    TypeLength{"rational", 8},
    TypeLength{"tiledesc", 9},
    TypeLength{"timecode", 8},
    TypeLength{"v2d", 16},
    TypeLength{"v2f", 8},
    TypeLength{"v2i", 8},
    TypeLength{"v3d", 24},
    TypeLength{"v3f", 12},
    TypeLength{"v3i", 12},
};

/// The length of a list of channels: names with 16 bytes each, up to an empty name.
std::int64_t channelListLength(std::istream& stream) {
    constexpr std::int64_t kChannelBytes = 16;
    const std::int64_t start = stream.tellg();
    while (stream && !readName(stream).empty())
        stream.seekg(kChannelBytes, std::ios::cur);
    return stream ? static_cast<std::int64_t>(stream.tellg()) - start : -1;
}

/// Whether the library will read as many bytes of the value as the file says that there are.
bool hasTrueLength(std::istream& stream, const std::string& type, std::int64_t length) {
    if (type == "chlist")
        return channelListLength(stream) == length;
    if (type == "preview") {
        const auto [width, height] = readWords<2>(stream);
        return length >= 8 && (length - 8) % 4 == 0 &&
               std::uint64_t{width} * height == static_cast<std::uint64_t>((length - 8) / 4);
    }
    const auto known = std::ranges::find(kLengths, type, &TypeLength::type);
    return known == kLengths.end() || known->length == length;
}

/// Looks at the value of an attribute that the library takes memory for.
std::string valueProblem(std::istream& stream, const std::string& name, std::int64_t fileSize,
                         int largestSide) {
    if (name == "dataWindow" || name == "displayWindow") {
        const auto [left, top, right, bottom] = readWords<4>(stream);
        const auto length = [](std::uint32_t low, std::uint32_t high) {
            return std::int64_t{static_cast<std::int32_t>(high)} - static_cast<std::int32_t>(low);
        };
        if (std::max(length(left, right), length(top, bottom)) >= largestSide)
            return "claims more texels than " + std::to_string(largestSide) + " per side";
    } else if (name == "tiles") {
        const auto [width, height] = readWords<2>(stream);
        if (width == 0 || height == 0 || width > kLargestTile ||
            std::int64_t{width} * height > kLargestTile)
            return "claims tiles of " + std::to_string(width) + " x " + std::to_string(height) +
                   " texels";
    } else if (name == "chunkCount" && readWords<1>(stream)[0] > fileSize) {
        return kTruncated;
    }
    return "";
}

}  // namespace

std::string exrHeaderProblem(const std::filesystem::path& file, int largestSide) {
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    const std::int64_t size = stream.tellg();
    stream.seekg(0);
    std::string magic(kMagic.size(), '\0');
    stream.read(magic.data(), static_cast<std::streamsize>(magic.size()));
    if (!stream || magic != kMagic)
        return "";
    const bool hasParts = (readWords<1>(stream)[0] & kMultiPart) != 0;
    for (bool isEmpty = true;;) {
        const std::string name = readName(stream);
        if (name.empty()) {  // the end of a header; of several, the last is empty
            if (!stream)
                return kTruncated;
            if (!hasParts || isEmpty)
                return "";
            isEmpty = true;
            continue;
        }
        isEmpty = false;
        const std::string type = readName(stream);
        const std::int64_t length = readWords<1>(stream)[0];
        const std::int64_t start = stream.tellg();
        if (!stream || length > size - start || !hasTrueLength(stream, type, length))
            return kTruncated;
        stream.seekg(start);
        if (std::string problem = valueProblem(stream, name, size, largestSide); !problem.empty())
            return problem;
        stream.seekg(start + length);
    }
}

}  // namespace relievo::textures
