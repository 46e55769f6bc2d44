#pragma once

#include "viewer/view_options.h"

namespace relievo::viewer {

/// Shows what `options` ask for in a window until the user closes it. The picture is that of a
/// headless run of the same options. Throws textures::InputError, and gl::GlError when there is no
/// display.
void runWindow(const ViewOptions& options);

}  // namespace relievo::viewer
