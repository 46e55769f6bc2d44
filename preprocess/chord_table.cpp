#include "preprocess/chord_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <map>

namespace relievo::preprocess {

ChordTable::ChordTable(const SampleLattice& lattice, const Rules& rules, double aspect) {
    const int subdivisions = lattice.subdivisions();
    const auto isSample = [&](int place) { return place % rules.sampleStep == 0; };
    const int reach = rules.farthest + rules.apexReach;
    for (int ay = -rules.apexReach; ay <= rules.apexReach; ++ay)
        for (int ax = -rules.apexReach; ax <= rules.apexReach; ++ax) {
            std::map<double, std::vector<std::ptrdiff_t>> rings;
            for (int y = -reach; y <= reach; ++y)
                for (int x = -reach; x <= reach; ++x) {
                    const int away = std::max(std::abs(x - ax), std::abs(y - ay));
                    const int limit = rules.aroundTexel ? std::max(std::abs(x), std::abs(y)) : away;
                    if (!isSample(x) || !isSample(y) || away < rules.nearest ||
                        limit > rules.farthest)
                        continue;
                    const double across = 1.0 * (x - ax) / subdivisions;
                    const double down = aspect * (y - ay) / subdivisions;
                    const double square = across * across + down * down - rules.correction;
                    assert(square > 0.0);
                    rings[square].push_back(lattice.stepTo(x, y));
                }
            apexes_.push_back({lattice.stepTo(ax, ay), static_cast<int>(rings.size())});
            for (const auto& [square, samples] : rings) {
                rings_.push_back({static_cast<float>(1.0 / std::sqrt(square)),
                                  static_cast<int>(samples.size())});
                samples_.insert(samples_.end(), samples.begin(), samples.end());
            }
        }
}

}  // namespace relievo::preprocess
