#pragma once

#include <filesystem>

#include "viewer/view_options.h"

namespace relievo::viewer {

/// Shows what `options` ask for in a window until the user closes it. The picture is that of a
/// headless run of the same options. Throws textures::InputError, and gl::GlError when there is no
/// display.
void runWindow(const ViewOptions& options);

/// The first of `folder`/view-001.png, view-002.png, … that does not exist.
std::filesystem::path nextPictureName(const std::filesystem::path& folder);

}  // namespace relievo::viewer
