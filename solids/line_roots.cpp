#include "solids/line_roots.h"

#include <algorithm>
#include <cmath>

#include "reference/difference_of_products.h"

namespace relievo::solids {
using reference::differenceOfProducts;

bool Quadratic::beginsInside() const noexcept {
    if (constant != 0.0)
        return constant < 0.0;
    if (linear != 0.0)
        return linear < 0.0;
    return quadratic <= 0.0;
}

SignChanges signChanges(const Quadratic& q, double end) noexcept {
    SignChanges changes;
    const auto add = [&](double s) {
        if (s > 0.0 && s < end)
            changes.places[static_cast<std::size_t>(changes.count++)] = s;
    };
    if (q.quadratic == 0.0) {
        if (q.linear != 0.0)
            add(-q.constant / q.linear);
        return changes;
    }
    const double discriminant =
        differenceOfProducts(q.linear, q.linear, 4.0 * q.quadratic, q.constant);
    if (!(discriminant > 0.0))  // a double root is a touch
        return changes;
    const double half = -0.5 * (q.linear + std::copysign(std::sqrt(discriminant), q.linear));
    const double first = half / q.quadratic;
    const double second = q.constant / half;
    add(std::min(first, second));
    add(std::max(first, second));
    return changes;
}

}  // namespace relievo::solids
