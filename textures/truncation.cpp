#include "textures/truncation.h"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace relievo::textures {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1A\n"sv;

std::uint32_t bigEndian32(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char byte : bytes.substr(0, 4))
        value = (value << 8) | static_cast<unsigned char>(byte);
    return value;
}

/// Walks the chunks (length, type, data, checksum) to IEND.
bool isTruncatedPng(std::string_view bytes) {
    constexpr std::size_t kFrame = 12;
    bytes.remove_prefix(8);
    while (bytes.size() >= kFrame) {
        const std::size_t chunk = kFrame + bigEndian32(bytes);
        if (chunk > bytes.size())
            return true;
        if (bytes.substr(4, 4) == "IEND"sv)
            return false;
        bytes.remove_prefix(chunk);
    }
    return true;
}

/// Within the compressed data 0xFF is followed by a stuffed 0 or a restart mark, so the last "start
/// of scan" must be followed by an "end of image". Previews in the header come before it.
bool isTruncatedJpeg(std::string_view bytes) {
    const std::size_t scan = bytes.rfind("\xFF\xDA"sv);
    return scan == std::string_view::npos ||
           bytes.find("\xFF\xD9"sv, scan) == std::string_view::npos;
}

}  // namespace

bool isTruncatedImage(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string start(8, '\0');
    stream.read(start.data(), static_cast<std::streamsize>(start.size()));
    const bool isPng = start == kPngSignature;
    const bool isJpeg = start.starts_with("\xFF\xD8\xFF"sv);
    if (!isPng && !isJpeg)
        return false;
    const std::string bytes = start + std::string(std::istreambuf_iterator<char>(stream),
                                                  std::istreambuf_iterator<char>());
    return isPng ? isTruncatedPng(bytes) : isTruncatedJpeg(bytes);
}

bool isPngOfNoSize(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    // The signature, then length and type of the header chunk, then width and height.
    std::string start(24, '\1');
    stream.read(start.data(), static_cast<std::streamsize>(start.size()));
    const std::string_view bytes = start;
    return bytes.starts_with(kPngSignature) &&
           (bigEndian32(bytes.substr(16)) == 0 || bigEndian32(bytes.substr(20)) == 0);
}

}  // namespace relievo::textures
