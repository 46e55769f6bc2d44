#include "solids/section_roots.h"

#include <algorithm>
#include <cmath>

namespace relievo::solids {
namespace {

// An end of a stretch.
struct Knot {
    double t;
    double value;
    double derivative;
    bool isInside;
};

// A line can touch a curve of the section in the fourth order; halving would take its time then,
// to find out about what is under rounding.
constexpr int kMostStretches = 4096;

class RootSearch {
  public:
    RootSearch(const SectionCell& section, std::vector<double>& places)
        : section_(section), places_(places), rounding_(section.rounding()) {}

    [[nodiscard]] Knot knot(double t) const {
        return {t, section_.value(t), section_.derivative(t), section_.isInside(t)};
    }

    void search(const Knot& a, const Knot& b) {
        const double length = b.t - a.t;
        const double bend = section_.curvature(a.t, b.t) * length;
        // The function keeps within bend·length/8 of its chord.
        const double sag = 0.125 * bend * length;
        const bool isFlat = std::max(std::abs(a.value), std::abs(b.value)) + sag <= rounding_;
        const bool isMonotone = std::abs(a.derivative) > bend || std::abs(b.derivative) > bend;
        const double middle = a.t + 0.5 * length;
        if (isFlat || isMonotone || ++stretches_ > kMostStretches || middle <= a.t ||
            middle >= b.t) {
            if (a.isInside != b.isInside)
                places_.push_back(refine(a, b));
            return;
        }
        if (a.isInside == b.isInside && std::min(std::abs(a.value), std::abs(b.value)) > sag)
            return;
        const Knot m = knot(middle);
        search(a, m);
        search(m, b);
    }

  private:
    // The change of sign between two places, by Newton's method within a bracket.
    [[nodiscard]] double refine(Knot a, Knot b) const {
        for (int k = 0; k < 200; ++k) {
            const Knot& best = std::abs(a.value) < std::abs(b.value) ? a : b;
            double t = best.t - best.value / best.derivative;
            const double middle = a.t + 0.5 * (b.t - a.t);
            if (middle <= a.t || middle >= b.t)
                break;
            if (std::abs(t - best.t) <= 0x1p-52 * std::abs(best.t))
                return best.t;
            if (!(t > a.t && t < b.t) || k % 4 == 3)
                t = middle;
            const Knot m = knot(t);
            if (m.value == 0.0)
                return t;
            (m.isInside == a.isInside ? a : b) = m;
        }
        return std::abs(a.value) < std::abs(b.value) ? a.t : b.t;
    }

    const SectionCell& section_;
    std::vector<double>& places_;
    double rounding_;
    int stretches_ = 0;
};

}  // namespace

double RadialLine::radius(double t) const noexcept {
    return std::hypot(closest, along(t));
}

glm::dvec2 SectionCell::place(double t) const noexcept {
    return {line.radius(t) * texels - firstColumn, rowStart + rowSpeed * t};
}

double SectionCell::value(double t) const noexcept {
    return cell.depth(place(t)) - extension;
}

double SectionCell::derivative(double t) const noexcept {
    const glm::dvec2 gradient = cell.gradient(place(t));
    const double radius = line.radius(t);
    // On the axis itself, where the radius has no derivative, the section is constant along it.
    const double columnSpeed = radius > 0.0 ? texels * line.speed * (line.along(t) / radius) : 0.0;
    return gradient.x * columnSpeed + gradient.y * rowSpeed;
}

double SectionCell::curvature(double a, double b) const noexcept {
    const double slope =
        std::max(std::abs(cell.gradient(place(a)).x), std::abs(cell.gradient(place(b)).x));
    const double radius = std::min(line.radius(a), line.radius(b));
    if (line.speed == 0.0 || slope == 0.0 || radius == 0.0)
        return 0.0;
    // s' = c·w/s, s'' = c²·m²/s³.
    const double ratio = line.closest / radius;
    const double bend = texels * line.speed * line.speed * ratio * ratio / radius;
    const double columnSpeed = texels * line.speed *
                               std::max(std::abs(line.along(a)) / line.radius(a),
                                        std::abs(line.along(b)) / line.radius(b));
    return 2.0 * std::abs(cell.twist * rowSpeed) * columnSpeed + slope * bend;
}

double SectionCell::rounding() const noexcept {
    return 0x1p-52 * (std::abs(cell.corner) + std::abs(extension) +
                      (std::abs(cell.slope.x) + std::abs(cell.twist)) * (2.0 + firstColumn) +
                      std::abs(cell.slope.y));
}

bool SectionCell::isInside(double t) const noexcept {
    const double here = value(t);
    return here < 0.0 || (here == 0.0 && derivative(t) <= 0.0);
}

void appendSignChanges(const SectionCell& section, double a, double b,
                       std::vector<double>& places) {
    if (!(a < b) || (section.line.speed == 0.0 && section.rowSpeed == 0.0))
        return;
    RootSearch search(section, places);
    search.search(search.knot(a), search.knot(b));
}

}  // namespace relievo::solids
