#include "tests/viewer/picture_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace relievo::tests {
namespace {

// Grey values less their mean.
std::vector<double> centredGreys(const viewer::Picture& picture) {
    std::vector<double> greys;
    for (std::size_t k = 0; k < picture.rgba.size(); k += 4)
        greys.push_back((picture.rgba[k] + picture.rgba[k + 1] + picture.rgba[k + 2]) / 3.0);
    const double mean =
        std::accumulate(greys.begin(), greys.end(), 0.0) / static_cast<double>(greys.size());
    for (double& grey : greys)
        grey -= mean;
    return greys;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

viewer::Picture crop(const viewer::Picture& picture, const PictureRegion& region) {
    if (region.x < 0 || region.y < 0 || region.x + region.width > picture.width ||
        region.y + region.height > picture.height)
        throw std::out_of_range("the region is not within the picture");
    viewer::Picture part(region.width, region.height);
    for (int y = 0; y < region.height; ++y)
        std::copy_n(picture.pixel(region.x, region.y + y), 4 * region.width, part.pixel(0, y));
    return part;
}

double contrast(const viewer::Picture& picture) {
    const std::vector<double> greys = centredGreys(picture);
    return std::sqrt(product(greys, greys) / static_cast<double>(greys.size()));
}

double correlation(const viewer::Picture& a, const viewer::Picture& b) {
    const std::vector<double> first = centredGreys(a);
    const std::vector<double> second = centredGreys(b);
    if (first.size() != second.size())
        throw std::invalid_argument("the pictures differ in size");
    const double scale = std::sqrt(product(first, first) * product(second, second));
    return scale > 0 ? product(first, second) / scale : 0.0;
}

}  // namespace relievo::tests
