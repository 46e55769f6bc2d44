#pragma once

#include <string>
#include <vector>

#include "viewer/picture.h"

namespace relievo::viewer {

/// One picture of a contact sheet with up to two lines of text above it.
struct SheetCell {
    Picture picture;
    std::string title;
    std::string subtitle;
};

/// Pictures of one size in rows, on dark grey, each under its label; `footer` (may be empty) stands
/// below them, at the left. Every row must have at least one cell.
Picture makeContactSheet(const std::vector<std::vector<SheetCell>>& rows, const Picture& footer);

}  // namespace relievo::viewer
