#pragma once

#include "viewer/view_options.h"

namespace relievo::viewer {

/// Renders what `options` ask for without a window, writes the pictures, and prints each stage with
/// its counts. Throws textures::InputError, gl::GlError.
void runHeadless(const ViewOptions& options);

}  // namespace relievo::viewer
