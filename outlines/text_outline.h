#pragma once

#include <filesystem>
#include <string>

#include "outlines/outline.h"

namespace relievo::outlines {

/// A line of text (UTF-8) as the outlines of its glyphs, with the font's own kerning and ligatures.
/// The tile is what the text covers with a margin of an eighth of its height on each side. Curves
/// become polylines that are within `tolerance` (tile widths, > 0) of them.
///
/// Throws textures::InputError for a file that is no font, text that is not UTF-8 or covers
/// nothing, and for characters that the font has no glyph for.
Drawing readTextDrawing(const std::filesystem::path& font, const std::string& text,
                        double tolerance);

}  // namespace relievo::outlines
