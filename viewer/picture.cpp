#include "viewer/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "textures/image_writer.h"
#include "textures/input_error.h"
#include "textures/picture_file.h"

namespace relievo::viewer {

void writePicture(const std::filesystem::path& file, const Picture& picture) {
    std::vector<textures::Plane> planes(3, textures::Plane(picture.width, picture.height));
    for (std::size_t k = 0; k < planes[0].texels.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
            planes[c].texels[k] = picture.rgba[4 * k + c];
    const bool exr = file.extension() == ".exr";
    textures::writePicture(file, planes,
                           exr ? textures::StorageFormat::Half : textures::StorageFormat::U8);
}

Picture readPicture(const std::filesystem::path& file) {
    const std::vector<textures::Plane> planes = textures::readPicture(file);
    Picture picture(planes[0].width, planes[0].height);
    const bool isColor = planes.size() >= 3;
    for (std::size_t k = 0; k < planes[0].texels.size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c)
            picture.rgba[4 * k + c] = planes[isColor ? c : 0].texels[k];
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

void writeChannels(const std::filesystem::path& file, const std::vector<NamedPlane>& planes) {
    if (file.extension() != ".exr")
        throw textures::InputError(
            fmt::format("{}: raw numbers with named channels need OpenEXR, expected a name that "
                        "ends in .exr",
                        file.string()));
    textures::ImageContent content;
    content.format = textures::StorageFormat::Float;
    for (const NamedPlane& named : planes) {
        content.planes.push_back(named.plane);
        content.channelNames.push_back(named.name);
    }
    textures::writeImage(file, content);
}

}  // namespace relievo::viewer
