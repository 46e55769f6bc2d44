#pragma once

#include <cmath>

namespace relievo::reference {

/// a·b − c·d with an error of about one unit in the last place (Kahan): the plain form loses every
/// digit where the two products cancel, which is where a ray grazes a surface.
inline double differenceOfProducts(double a, double b, double c, double d) noexcept {
    const double product = c * d;
    const double productError = std::fma(-c, d, product);
    return std::fma(a, b, -product) + productError;
}

}  // namespace relievo::reference
