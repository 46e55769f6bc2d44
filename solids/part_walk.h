#pragma once

#include <optional>
#include <variant>

#include "solids/extrusion_walk.h"
#include "solids/revolution_walk.h"
#include "solids/solid_tracer.h"

namespace relievo::solids {

/// The crossings of a ray in the space of the whole with one part, in order.
class PartWalk {
  public:
    /// All references must outlive the walk; `cost` may be null.
    PartWalk(const SolidPart& part, const FreeSpace& freeSpace, const SolidRay& ray,
             const TraceOptions& options, TraceCost* cost);

    /// The next crossing, in the parameter of the ray; `outward` in the coordinates of the whole.
    std::optional<SolidCrossing> next();

  private:
    const SolidPart* part_;
    double begin_ = 0.0;  // of the span, in the ray's parameter
    int exponent_ = 0;    // the span's parameter is 2^exponent times the ray's
    double last_ = 0.0;
    std::variant<std::monostate, ExtrusionWalk, RevolutionWalk> walk_;
};

}  // namespace relievo::solids
