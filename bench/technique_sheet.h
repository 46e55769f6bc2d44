#pragma once

#include <string>
#include <vector>

#include "bench/sheet_view.h"

namespace relievo::bench {

/// The same view by every technique (names of the technique registry) with its default parameters,
/// and by the exact hits, each with its share of wrong first hits and its lookups. Magenta is where
/// the steps ran out. Throws gl::GlError when there is no context.
viewer::Picture makeTechniqueSheet(const SheetOptions& options,
                                   const std::vector<std::string>& techniques);

}  // namespace relievo::bench
