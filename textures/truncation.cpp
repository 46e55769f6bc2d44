#include "textures/truncation.h"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace relievo::textures {

namespace {

using namespace std::string_view_literals;

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
    const bool isPng = start == "\x89PNG\r\n\x1A\n"sv;
    const bool isJpeg = start.starts_with("\xFF\xD8\xFF"sv);
    if (!isPng && !isJpeg)
        return false;
    const std::string bytes = start + std::string(std::istreambuf_iterator<char>(stream),
                                                  std::istreambuf_iterator<char>());
    return isPng ? isTruncatedPng(bytes) : isTruncatedJpeg(bytes);
}

}  // namespace relievo::textures
