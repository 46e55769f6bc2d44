#include "viewer/picture.h"

#include <algorithm>
#include <cassert>

#include "textures/atomic_file.h"
#include "textures/file_extension.h"
#include "textures/image_writer.h"
#include "textures/picture_file.h"

namespace relievo::viewer {

namespace {

// Half floats keep more than 8 bits of a picture, and a viewer of EXR files shows them.
textures::StorageFormat pictureFormat(const std::filesystem::path& file) {
    return textures::lowerExtension(file) == ".exr" ? textures::StorageFormat::Half
                                                    : textures::StorageFormat::U8;
}

}  // namespace

void requirePictureFile(const std::filesystem::path& file) {
    textures::requireExtensionFor(file, pictureFormat(file));
    const textures::AtomicFile probe(file);
}

void writePicture(const std::filesystem::path& file, const Picture& picture) {
    std::vector<textures::Plane> planes(3, textures::Plane(picture.width, picture.height));
    for (std::size_t k = 0; k < planes[0].texels.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
            planes[c].texels[k] = picture.rgba[4 * k + c];
    textures::writePicture(file, planes, pictureFormat(file));
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

void requireChannelFile(const std::filesystem::path& file) {
    textures::requireExtensionFor(file, textures::StorageFormat::Float);
    const textures::AtomicFile probe(file);
}

void writeChannels(const std::filesystem::path& file, const std::vector<NamedPlane>& planes) {
    textures::requireExtensionFor(file, textures::StorageFormat::Float);
    textures::ImageContent content;
    content.format = textures::StorageFormat::Float;
    for (const NamedPlane& named : planes) {
        content.planes.push_back(named.plane);
        content.channelNames.push_back(named.name);
    }
    textures::writeImage(file, content);
}

}  // namespace relievo::viewer
