#pragma once

#include <cstddef>
#include <vector>

#include "viewer/picture.h"

namespace relievo::viewer {

/// What is wrong with the pictures of a moving camera, in relative luminance (linear, 1 is white).
struct TemporalErrorStatistics {
    /// Root mean square over the pixels of the standard deviation over time of frame − truth: what
    /// comes and goes while nothing should change.
    double sparkle = 0.0;
    /// Root mean square over the pixels of the mean over time of frame − truth: what stays.
    double lasting = 0.0;
    /// Mean of frame − truth over pixels and time: how much brighter the pictures are as a whole.
    double bias = 0.0;
};

/// Collects pictures of one size, a frame at a time, beside the truth for the same camera.
class TemporalError {
  public:
    /// Both pictures must have the size of those before.
    void add(const Picture& frame, const Picture& truth);
    /// Needs two frames or more.
    [[nodiscard]] TemporalErrorStatistics statistics() const;

  private:
    std::size_t frames_ = 0;
    std::vector<double> sums_;     // of frame − truth, one a pixel
    std::vector<double> squares_;  // likewise
};

/// Relative luminance (Rec. 709) of an sRGB-encoded pixel of four values.
double luminance(const float* pixel);

/// The mean in linear light of every `samples` × `samples` pixels of `fine`, whose sides are
/// multiples of that, as a picture of sRGB-encoded colours.
Picture averaged(const Picture& fine, int samples);

}  // namespace relievo::viewer
