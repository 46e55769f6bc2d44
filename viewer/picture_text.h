#pragma once

#include <glm/vec3.hpp>
#include <string_view>

#include "viewer/picture.h"

namespace relievo::viewer {

/// Draws one line of text (UTF-8, DejaVu Sans) with its baseline at (x,y), `size` pixels high; what
/// does not fit is cut. Throws std::runtime_error when the font is not installed.
void drawText(Picture& picture, std::string_view text, int x, int y, int size, glm::vec3 color);

/// Width of the text in pixels.
int textWidth(std::string_view text, int size);

}  // namespace relievo::viewer
