#include "textures/halved_plane.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace relievo::textures {
namespace {

// The two or three samples of a line that one sample of half as many covers, and how much of each.
struct Cover {
    int first = 0;
    std::array<double, 3> weights{};  // add up to 1; 0 behind the end of the line
};

// Sample i of m covers [i·n/m, (i+1)·n/m) of the n samples, which starts within sample 2i: n/m is
// 2, or 2 + 1/m for odd n.
Cover coverOf(int i, int fine, int coarse) {
    const double length = static_cast<double>(fine) / coarse;
    const double start = i * length;
    Cover cover;
    cover.first = fine == 1 ? 0 : 2 * i;
    for (int k = 0; k < 3; ++k) {
        const double left = std::max(start, static_cast<double>(cover.first + k));
        const double right = std::min(start + length, static_cast<double>(cover.first + k + 1));
        cover.weights[static_cast<std::size_t>(k)] =
            cover.first + k < fine ? std::max(right - left, 0.0) / length : 0.0;
    }
    return cover;
}

std::vector<Cover> coversOf(int fine, int coarse) {
    std::vector<Cover> covers;
    for (int i = 0; i < coarse; ++i)
        covers.push_back(coverOf(i, fine, coarse));
    return covers;
}

double meanOf(const Plane& fine, const Cover& columns, const Cover& rows) {
    double sum = 0.0;
    double weights = 0.0;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            const double weight = columns.weights[static_cast<std::size_t>(x)] *
                                  rows.weights[static_cast<std::size_t>(y)];
            if (weight > 0.0) {
                sum += weight * fine.at(columns.first + x, rows.first + y);
                weights += weight;
            }
        }
    return sum / weights;
}

}  // namespace

Plane halvedByArea(const Plane& fine) {
    assert(fine.width > 0 && fine.height > 0);
    Plane coarse(std::max(fine.width / 2, 1), std::max(fine.height / 2, 1));
    const std::vector<Cover> columns = coversOf(fine.width, coarse.width);
    const std::vector<Cover> rows = coversOf(fine.height, coarse.height);
    for (int j = 0; j < coarse.height; ++j)
        for (int i = 0; i < coarse.width; ++i)
            coarse.at(i, j) = static_cast<float>(meanOf(fine, columns[static_cast<std::size_t>(i)],
                                                        rows[static_cast<std::size_t>(j)]));
    return coarse;
}

}  // namespace relievo::textures
