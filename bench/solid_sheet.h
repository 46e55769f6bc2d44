#pragma once

#include <string_view>
#include <vector>

#include "bench/sheet_view.h"

namespace relievo::bench {

/// Names of groups of figures (solid_figures.h): "maps", "boxes", "compared", "collection".
const std::vector<std::string>& figureGroups();

/// Figures of solids, a row or more each; "all" groups, or one of figureGroups(). Of the options
/// the size is that of shape maps. Throws gl::GlError when there is no context.
viewer::Picture makeSolidSheet(const SheetOptions& options, std::string_view group);

}  // namespace relievo::bench
