#pragma once

#include <filesystem>
#include <vector>

#include "outlines/outline.h"

namespace relievo::outlines {

/// Reads the filled shapes of an SVG file: path, rect, circle, ellipse, polygon and polyline,
/// within groups, with their transforms and fill rules; what has the fill `none` or is not
/// displayed does not count, nor do strokes. The tile is the viewBox, or else the width and height
/// of the document. Subpaths that are left open are closed by a straight line, as SVG fills them.
/// Curves become polylines that are within `tolerance` (tile widths, > 0) of them.
///
/// Throws textures::InputError for a file that cannot be read, is no SVG, has no size or a wrong
/// path or transform, or uses what is not supported here (`use`, `text`, style sheets).
Drawing readSvgDrawing(const std::filesystem::path& file, double tolerance);

}  // namespace relievo::outlines
