#pragma once

#include <array>
#include <memory>
#include <mutex>

#include "solids/solid_tracer.h"
#include "viewer/measured_frame.h"

namespace relievo::viewer {

/// How a measured search of a solid compares with the exact one.
struct SolidVerdict {
    bool isRight = false;    ///< nothing but the rounding of floats is between the two
    bool isTangent = false;  ///< and it decides whether, or at which of two places, the ray hits
    /// Otherwise, where both hit: how far the hit is from the surface, in texels of its part.
    double deviation = 0.0;
};

/// What the rounding of floats may do to the hits of a search of solids (shaders/relievo/solid),
/// and nothing else.
class SolidRounding {
  public:
    explicit SolidRounding(const solids::Compound& compound);

    /// A hit is right where the exact one is, up to the rounding of t. Near tangents, where places
    /// are as far apart as it pleases rounding, it is right when the solid shrunk by the rounding
    /// is not met before and the grown one is met there; a miss is right when the shrunk solid is
    /// missed. A search that ran out of steps is not right. Safe to call from several threads.
    [[nodiscard]] SolidVerdict judge(const MeasuredPixel& pixel) const;

    [[nodiscard]] const solids::SolidTracer& exact() const noexcept { return exact_; }

  private:
    static constexpr int kLevels = 24;

    // Solids between which those are that floats may see.
    struct Bounds {
        solids::SolidTracer shrunk;
        solids::SolidTracer grown;
    };

    [[nodiscard]] const Bounds& boundsFor(const solids::SolidRay& ray, double t) const;
    [[nodiscard]] bool isExplained(const MeasuredPixel& pixel, const solids::SolidRay& ray,
                                   double slack) const;
    [[nodiscard]] bool isBetweenBounds(const MeasuredPixel& pixel, const solids::SolidRay& ray,
                                       double slack) const;

    solids::SolidTracer exact_;
    mutable std::mutex mutex_;
    mutable std::array<std::unique_ptr<Bounds>, kLevels> bounds_;  // for lengths of powers of two
};

/// The ray of a pixel, as the search was given it.
solids::SolidRay rayOf(const MeasuredPixel& pixel);

}  // namespace relievo::viewer
