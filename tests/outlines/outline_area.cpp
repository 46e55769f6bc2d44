#include "outline_area.h"

namespace relievo::outlines {

double signedArea(const Contour& contour) {
    double twice = 0.0;
    for (std::size_t k = 0; k < contour.size(); ++k) {
        const glm::dvec2& a = contour[k];
        const glm::dvec2& b = contour[(k + 1) % contour.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

double signedArea(const std::vector<Outline>& shapes) {
    double sum = 0.0;
    for (const Outline& shape : shapes)
        for (const Contour& contour : shape.contours)
            sum += signedArea(contour);
    return sum;
}

}  // namespace relievo::outlines
