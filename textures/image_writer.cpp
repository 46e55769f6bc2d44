#include "textures/image_writer.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cassert>
#include <cstdint>
#include <memory>
#include <span>

#include "textures/atomic_file.h"
#include "textures/file_extension.h"
#include "textures/input_error.h"

namespace relievo::textures {

namespace {

/// EXR and TIFF files carry a date: a fixed one, because the same maps must give the same bytes.
constexpr const char* kFixedDate = "2000:01:01 00:00:00";

OIIO::TypeDesc sampleType(StorageFormat format) {
    switch (format) {
        case StorageFormat::Float:
            return OIIO::TypeDesc::FLOAT;
        case StorageFormat::Half:
            return OIIO::TypeDesc::HALF;
        case StorageFormat::U16:
            return OIIO::TypeDesc::UINT16;
        case StorageFormat::U8:
            break;
    }
    return OIIO::TypeDesc::UINT8;
}

OIIO::ImageSpec specOf(const ImageContent& content, bool isPng) {
    const Plane& plane = content.planes.front();
    OIIO::ImageSpec spec(plane.width, plane.height, static_cast<int>(content.planes.size()),
                         sampleType(content.format));
    if (!content.channelNames.empty()) {
        spec.channelnames = content.channelNames;
        spec.alpha_channel = -1;
    }
    for (const auto& [name, value] : content.attributes)
        spec.attribute(name, value);
    spec.attribute("DateTime", kFixedDate);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    // Without this PNG data would read back as colours. (TIFF needs none, and a TIFF file that is
    // encoded in memory with sRGB comes out damaged.)
    if (isPng)
        spec.attribute("oiio:ColorSpace", content.isColour ? "sRGB" : "Linear");
    return spec;
}

template <class Sample>
std::vector<Sample> interleave(const std::vector<Plane>& planes) {
    std::vector<Sample> samples(planes.size() * planes.front().texels.size());
    for (std::size_t c = 0; c < planes.size(); ++c)
        for (std::size_t t = 0; t < planes[c].texels.size(); ++t)
            samples[t * planes.size() + c] = static_cast<Sample>(planes[c].texels[t]);
    return samples;
}

bool writeSamples(OIIO::ImageOutput& output, const ImageContent& content) {
    switch (content.format) {
        case StorageFormat::U8:
            return output.write_image(OIIO::TypeDesc::UINT8,
                                      interleave<std::uint8_t>(content.planes).data());
        case StorageFormat::U16:
            return output.write_image(OIIO::TypeDesc::UINT16,
                                      interleave<std::uint16_t>(content.planes).data());
        case StorageFormat::Half:
        case StorageFormat::Float:
            break;
    }
    return output.write_image(OIIO::TypeDesc::FLOAT, interleave<float>(content.planes).data());
}

/// The bytes of the file, encoded in memory: image libraries lose the reason why a write failed,
/// and some the failure itself.
std::vector<unsigned char> encode(const std::filesystem::path& file, const ImageContent& content) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> output =
        OIIO::ImageOutput::create(file.string(), &memory);
    const bool isPng = lowerExtension(file) == ".png";
    const bool good = output && output->open(file.string(), specOf(content, isPng)) &&
                      writeSamples(*output, content) && output->close();
    if (!good)
        throw InputError(fmt::format("{}: cannot be encoded: {}", file.string(),
                                     output ? output->geterror() : OIIO::geterror()));
    return bytes;
}

}  // namespace

void writeImage(const std::filesystem::path& file, const ImageContent& content) {
    assert(!content.planes.empty());
    AtomicFile output(file);
    const std::vector<unsigned char> bytes = encode(file, content);
    output.write(std::as_bytes(std::span(bytes)));
    output.commit();
}

}  // namespace relievo::textures
