#pragma once

#include <array>

namespace relievo::solids {

/// constant + linear·s + quadratic·s²: an implicit function along a line.
struct Quadratic {
    double constant = 0.0;
    double linear = 0.0;
    double quadratic = 0.0;

    /// Whether it is negative just after s = 0, or 0 throughout.
    [[nodiscard]] bool beginsInside() const noexcept;
};

/// Where a quadratic changes its sign.
struct SignChanges {
    std::array<double, 2> places{};
    int count = 0;
};

/// The places in 0 < s < end where `q` changes its sign, in order. Its discriminant is computed
/// without cancellation (Kahan), so that grazing lines keep their digits.
SignChanges signChanges(const Quadratic& q, double end) noexcept;

}  // namespace relievo::solids
