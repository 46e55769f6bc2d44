#pragma once

#include "viewer/view_options.h"

namespace relievo::viewer {

/// Shows a scene or a shape in a window, with all that can be edited in a panel, until it is
/// closed. Throws textures::InputError, gl::GlError without a display.
void runSolidWindow(const ViewOptions& options);

}  // namespace relievo::viewer
