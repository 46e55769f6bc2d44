#include "preprocess/chord_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace relievo::preprocess {

namespace {

// In a texel that is much higher than wide, or wider than high, the correction may be as long as a
// chord: it then counts as all but vertical.
constexpr double kShortest = 1e-24;

ChordTable::SquaredLength lengthsOf(const ChordTable::Rules& rules, int subdivisions,
                                    double aspect) {
    return [=](ChordTable::Point apex, ChordTable::Point sample) -> std::optional<double> {
        const int away = std::max(std::abs(sample.x - apex.x), std::abs(sample.y - apex.y));
        const int limit =
            rules.aroundTexel ? std::max(std::abs(sample.x), std::abs(sample.y)) : away;
        if (sample.x % rules.sampleStep != 0 || sample.y % rules.sampleStep != 0 ||
            away < rules.nearest || limit > rules.farthest)
            return std::nullopt;
        const double across = 1.0 * (sample.x - apex.x) / subdivisions;
        const double down = aspect * (sample.y - apex.y) / subdivisions;
        return across * across + down * down - rules.correction;
    };
}

}  // namespace

ChordTable::ChordTable(const SampleLattice& lattice, const Rules& rules, double aspect)
    : ChordTable(lattice, rules.apexReach, rules.farthest + rules.apexReach,
                 lengthsOf(rules, lattice.subdivisions(), aspect)) {}

ChordTable::ChordTable(const SampleLattice& lattice, int apexReach, int sampleReach,
                       const SquaredLength& squaredLength) {
    for (int ay = -apexReach; ay <= apexReach; ++ay)
        for (int ax = -apexReach; ax <= apexReach; ++ax) {
            std::map<double, std::vector<std::ptrdiff_t>> rings;
            for (int y = -sampleReach; y <= sampleReach; ++y)
                for (int x = -sampleReach; x <= sampleReach; ++x)
                    if (const auto square = squaredLength({ax, ay}, {x, y}))
                        rings[std::max(*square, kShortest)].push_back(lattice.stepTo(x, y));
            apexes_.push_back({lattice.stepTo(ax, ay), static_cast<int>(rings.size())});
            for (const auto& [square, samples] : rings) {
                rings_.push_back({static_cast<float>(1.0 / std::sqrt(square)),
                                  static_cast<int>(samples.size())});
                samples_.insert(samples_.end(), samples.begin(), samples.end());
            }
        }
}

}  // namespace relievo::preprocess
