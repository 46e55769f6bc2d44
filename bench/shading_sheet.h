#pragma once

#include "bench/sheet_view.h"

namespace relievo::bench {

/// A row a depth scale, from flat to 0.2: Blinn–Phong, and a dielectric and a metal by the
/// microfacet model, with baked occlusion. Of the options, columns and depthScale do not matter.
/// Throws gl::GlError when there is no context.
viewer::Picture makeShadingSheet(const SheetOptions& options);

}  // namespace relievo::bench
