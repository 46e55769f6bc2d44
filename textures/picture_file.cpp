#include "textures/picture_file.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "textures/channel_coding.h"
#include "textures/file_extension.h"
#include "textures/image_reader.h"
#include "textures/image_writer.h"

namespace relievo::textures {

void writePicture(const std::filesystem::path& file, std::span<const Plane> planes,
                  StorageFormat format) {
    assert(planes.size() == 1 || planes.size() == 3 || planes.size() == 4);
    requireExtensionFor(file, format);
    ImageContent content;
    content.planes.assign(planes.begin(), planes.end());
    content.format = format;
    content.isColour = isPackedFormat(format);
    if (isPackedFormat(format))
        for (Plane& plane : content.planes)
            for (float& value : plane.texels)
                value = static_cast<float>(
                    std::nearbyint(std::clamp(value, 0.0f, 1.0f) * maximumCode(format)));
    writeImage(file, content);
}

std::vector<Plane> readPicture(const std::filesystem::path& file) {
    ImageReader reader(file);
    return reader.readChannels(0, static_cast<int>(reader.info().channelNames.size()));
}

}  // namespace relievo::textures
