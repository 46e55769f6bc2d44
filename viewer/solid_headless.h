#pragma once

#include "viewer/view_options.h"

namespace relievo::viewer {

/// Whether relievo-view shows a file as a scene or a shape, and not as a relief: a scene file
/// (.json), a map of the kind `shape`, or what relievo-bake shape would bake (an SVG drawing,
/// FONT:TEXT). Throws textures::InputError for a map that cannot be read.
bool isSolidFile(const std::string& file);

/// Renders a scene or a shape into options.output: one picture, or a sheet with one for each of
/// options.techniques. Prints what it took. Throws textures::InputError and commands::UsageError.
void runSolidHeadless(const ViewOptions& options);

}  // namespace relievo::viewer
