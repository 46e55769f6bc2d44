#include "textures/content_hash.h"

#include <OpenImageIO/hash.h>
#include <fmt/format.h>

#include <cstdint>

namespace relievo::textures {

std::string contentHash(const Plane& plane) {
    // Fingerprint64, unlike Hash64, promises never to change.
    const std::uint64_t samples = OIIO::farmhash::Fingerprint64(
        reinterpret_cast<const char*>(plane.texels.data()), plane.texels.size() * sizeof(float));
    const std::string content = fmt::format("{}x{}:{:016x}", plane.width, plane.height, samples);
    return fmt::format("{:016x}", OIIO::farmhash::Fingerprint64(content.data(), content.size()));
}

}  // namespace relievo::textures
