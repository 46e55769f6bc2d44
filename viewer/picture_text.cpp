#include "viewer/picture_text.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <stdexcept>

namespace relievo::viewer {
namespace {

constexpr std::string_view kFont = "DejaVuSans";

}  // namespace

void drawText(Picture& picture, std::string_view text, int x, int y, int size, glm::vec3 color) {
    const OIIO::ImageSpec spec(picture.width, picture.height, 4, OIIO::TypeDesc::FLOAT);
    OIIO::ImageBuf buffer(spec, picture.rgba.data());
    const float rgba[4] = {color.r, color.g, color.b, 1.0f};
    if (!OIIO::ImageBufAlgo::render_text(buffer, x, y, OIIO::string_view(text.data(), text.size()),
                                         size, OIIO::string_view(kFont.data(), kFont.size()), rgba))
        throw std::runtime_error(fmt::format(
            "labels need the font {} (package fonts-dejavu-core): {}", kFont, buffer.geterror()));
}

int textWidth(std::string_view text, int size) {
    return OIIO::ImageBufAlgo::text_size(OIIO::string_view(text.data(), text.size()), size,
                                         OIIO::string_view(kFont.data(), kFont.size()))
        .width();
}

}  // namespace relievo::viewer
