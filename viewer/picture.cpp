#include "viewer/picture.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <memory>

#include "textures/atomic_file.h"
#include "textures/input_error.h"

namespace relievo::viewer {
namespace {

using textures::InputError;

// Opens, writes and closes `file` whole; every step can fail on a full disk.
void writeImage(const std::filesystem::path& file, const OIIO::ImageSpec& spec,
                const std::vector<float>& texels) {
    textures::AtomicFile temporary(file);
    const std::string path = temporary.path().string();
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
    if (!output)
        throw InputError(
            fmt::format("{}: cannot write this kind of file, expected a name that ends in "
                        ".png, .exr, .tif or .jpg",
                        file.string()));
    const bool written =
        output->open(path, spec) && output->write_image(OIIO::TypeDesc::FLOAT, texels.data());
    if (!output->close() || !written)
        throw InputError(fmt::format("{}: cannot be written: {}", file.string(),
                                     output->has_error() ? output->geterror() : "disk full?"));
    temporary.commit();
}

}  // namespace

void writePicture(const std::filesystem::path& file, const Picture& picture) {
    const bool exr = file.extension() == ".exr";
    OIIO::ImageSpec spec(picture.width, picture.height, exr ? 4 : 3,
                         exr ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("DateTime", "2000:01:01 00:00:00");  // the same picture gives the same bytes
    if (exr) {
        writeImage(file, spec, picture.rgba);
        return;
    }
    std::vector<float> rgb;
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (std::size_t k = 0; k < picture.rgba.size(); ++k)
        if (k % 4 != 3)
            rgb.push_back(picture.rgba[k]);
    writeImage(file, spec, rgb);
}

void writeChannels(const std::filesystem::path& file, const std::vector<NamedPlane>& planes) {
    assert(!planes.empty());
    if (file.extension() != ".exr")
        throw InputError(
            fmt::format("{}: raw numbers with named channels need OpenEXR, expected a "
                        "name that ends in .exr",
                        file.string()));
    const textures::Plane& first = planes.front().plane;
    OIIO::ImageSpec spec(first.width, first.height, static_cast<int>(planes.size()),
                         OIIO::TypeDesc::FLOAT);
    spec.channelnames.clear();
    for (const NamedPlane& named : planes)
        spec.channelnames.push_back(named.name);
    spec.attribute("DateTime", "2000:01:01 00:00:00");
    std::vector<float> texels(first.texels.size() * planes.size());
    for (std::size_t c = 0; c < planes.size(); ++c) {
        assert(planes[c].plane.texels.size() == first.texels.size());
        for (std::size_t k = 0; k < first.texels.size(); ++k)
            texels[k * planes.size() + c] = planes[c].plane.texels[k];
    }
    writeImage(file, spec, texels);
}

Picture readPicture(const std::filesystem::path& file) {
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(file.string());
    if (!input)
        throw InputError(fmt::format("{}: cannot be read as an image ({}), expected a colour image",
                                     file.string(), OIIO::geterror()));
    const OIIO::ImageSpec& spec = input->spec();
    const int channels = std::min(spec.nchannels, 3);
    Picture picture(spec.width, spec.height);
    std::vector<float> texels(static_cast<std::size_t>(spec.nchannels) * picture.rgba.size() / 4);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, texels.data()))
        throw InputError(fmt::format("{}: is damaged ({}), expected a whole colour image",
                                     file.string(), input->geterror()));
    for (std::size_t k = 0; k < picture.rgba.size() / 4; ++k) {
        const float* texel = &texels[k * static_cast<std::size_t>(spec.nchannels)];
        for (int c = 0; c < 3; ++c)
            picture.rgba[4 * k + static_cast<std::size_t>(c)] = texel[channels >= 3 ? c : 0];
        picture.rgba[4 * k + 3] = 1.0f;
    }
    return picture;
}

void paste(Picture& target, const Picture& source, int x, int y) {
    assert(x >= 0 && y >= 0 && x + source.width <= target.width &&
           y + source.height <= target.height);
    for (int row = 0; row < source.height; ++row)
        std::copy_n(source.pixel(0, row), 4 * source.width, target.pixel(x, y + row));
}

}  // namespace relievo::viewer
