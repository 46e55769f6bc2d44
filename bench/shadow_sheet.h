#pragma once

#include "bench/sheet_view.h"

namespace relievo::bench {

/// The same view without shadows, by every method of self-shadowing with its default parameters
/// under a light of 8° across, and by the exact visibility, each with its share of wrong pixels and
/// its lookups. Throws gl::GlError when there is no context.
viewer::Picture makeShadowSheet(const SheetOptions& options);

}  // namespace relievo::bench
