#include "bench/search_benchmark.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "bench/mean_ratio.h"
#include "commands/progress.h"
#include "preprocess/conservative_cones.h"
#include "preprocess/quick_cones.h"
#include "preprocess/relaxed_cones.h"
#include "preprocess/relaxed_cones_by_maxima.h"
#include "preprocess/roof_cones.h"
#include "reference/adversarial_rays.h"
#include "reference/bilinear_tracer.h"
#include "reference/cone_search.h"
#include "reference/pyramid_search.h"
#include "reference/relaxed_search.h"
#include "reference/relief_search.h"
#include "reference/roof_search.h"
#include "textures/depth_pyramid.h"
#include "textures/sample_reliefs.h"

namespace relievo::bench {

namespace {

using preprocess::buildConservativeCones;
using preprocess::buildRelaxedCones;
using preprocess::ConeGuarantee;
using reference::DescendingRay;
using reference::MapSearchResult;
using textures::DepthMap;
using textures::Plane;

using Search = std::function<MapSearchResult(const DepthMap&, const DescendingRay&)>;

/// A search with its map.
struct PreparedSearch {
    Search search;
    std::optional<double> meanRatio;
};

struct KindEntry {
    SearchKind kind;
    PreparedSearch (*prepare)(const DepthMap& relief);
};

/// A search with cones as its map.
template <class SearchByCones>
PreparedSearch prepareCones(Plane ratio, const SearchByCones& search) {
    const double mean = meanRatio(ratio);
    return {[cones = std::make_shared<const Plane>(std::move(ratio)), search](
                const DepthMap& relief, const DescendingRay& ray) {
                return search(relief, *cones, ray);
            },
            mean};
}

MapSearchResult stepOnly(const DepthMap& relief, const Plane& ratio, const DescendingRay& ray) {
    return reference::searchByCones(relief, ratio, ray);
}

MapSearchResult stepAndBisect(const DepthMap& relief, const Plane& ratio,
                              const DescendingRay& ray) {
    return reference::searchByRelaxedCones(relief, ratio, ray);
}

MapSearchResult stepAndSolve(const DepthMap& relief, const Plane& ratio, const DescendingRay& ray) {
    return reference::searchByRelaxedConesAndCells(relief, ratio, ray);
}

PreparedSearch preparePyramid(const DepthMap& relief) {
    const auto pyramid = std::make_shared<const textures::DepthPyramid>(
        textures::buildDepthPyramid(textures::leastDepthsOfCells(relief)));
    return {[pyramid](const DepthMap& map, const DescendingRay& ray) {
                return reference::searchByPyramid(map, pyramid->levels, ray);
            },
            std::nullopt};
}

template <int kSectors, int kBlock>
PreparedSearch prepareRoofs(const DepthMap& relief) {
    const auto roofs = std::make_shared<reference::RoofMap>();
    roofs->block = kBlock;
    double mean = 0.0;
    for (auto& [roof, ratio] : preprocess::buildRoofCones(relief, {kSectors, kBlock})) {
        mean += meanRatio(ratio) / kSectors;
        roofs->layers.push_back({std::move(roof), std::move(ratio)});
    }
    return {[roofs](const DepthMap& map, const DescendingRay& ray) {
                return reference::searchByRoofs(map, *roofs, ray);
            },
            mean};
}

const std::array kEntries{
    KindEntry{{"relief", "relief mapping, 32 linear and 5 binary steps"},
              [](const DepthMap&) {
                  return PreparedSearch{[](const DepthMap& relief, const DescendingRay& ray) {
                                            return reference::searchLinearBinary(relief, ray);
                                        },
                                        std::nullopt};
              }},
    KindEntry{{"pyramid", "pyramid of least depths, exact"}, preparePyramid},
    KindEntry{{"cones-texel", "conservative cones of texel centres, to 1e-4 of the depth"},
              [](const DepthMap& relief) {
                  return prepareCones(buildConservativeCones(relief, ConeGuarantee::Texel),
                                      stepOnly);
              }},
    KindEntry{{"cones-bilinear", "conservative cones of the whole surface, to 1e-4 of the depth"},
              [](const DepthMap& relief) {
                  return prepareCones(buildConservativeCones(relief, ConeGuarantee::Bilinear),
                                      stepOnly);
              }},
    KindEntry{{"cones-bilinear-cell", "the same, solving cells: exact"},
              [](const DepthMap& relief) {
                  return prepareCones(buildConservativeCones(relief, ConeGuarantee::Bilinear),
                                      reference::searchByConesAndCells);
              }},
    KindEntry{{"cones-quick-cell", "quick cones of the max-mip, solving cells"},
              [](const DepthMap& relief) {
                  return prepareCones(preprocess::buildQuickCones(relief),
                                      reference::searchByConesAndCells);
              }},
    KindEntry{{"roof-1", "roof cones, 1 sector, blocks of 3×3 cells: exact"}, prepareRoofs<1, 1>},
    KindEntry{{"roof-4", "4 sectors, blocks of 2×2 cells ahead: exact"}, prepareRoofs<4, 1>},
    KindEntry{{"roof-8", "8 sectors, blocks of 2×2 cells ahead: exact"}, prepareRoofs<8, 1>},
    KindEntry{{"roof-1-far", "1 sector, blocks of 5×5 cells: exact"}, prepareRoofs<1, 2>},
    KindEntry{{"roof-4-far", "4 sectors, blocks of 3×3 cells ahead: exact"}, prepareRoofs<4, 2>},
    KindEntry{{"roof-8-far", "8 sectors, blocks of 3×3 cells ahead: exact"}, prepareRoofs<8, 2>},
    KindEntry{{"relaxed-bilinear", "relaxed cones of the whole surface, 10 bisections"},
              [](const DepthMap& relief) {
                  return prepareCones(buildRelaxedCones(relief, ConeGuarantee::Bilinear),
                                      stepAndBisect);
              }},
    KindEntry{{"relaxed-bilinear-cell", "the same, bisecting to a cell and solving it: exact"},
              [](const DepthMap& relief) {
                  return prepareCones(buildRelaxedCones(relief, ConeGuarantee::Bilinear),
                                      stepAndSolve);
              }},
    KindEntry{{"relaxed-texel", "relaxed cones of texel centres, 10 bisections"},
              [](const DepthMap& relief) {
                  return prepareCones(buildRelaxedCones(relief, ConeGuarantee::Texel),
                                      stepAndBisect);
              }},
    KindEntry{{"relaxed-maxima", "relaxed cones by local maxima, 10 bisections"},
              [](const DepthMap& relief) {
                  return prepareCones(preprocess::buildRelaxedConesByMaxima(relief), stepAndBisect);
              }},
};

const auto kKinds = [] {
    std::array<SearchKind, kEntries.size()> kinds;
    std::transform(kEntries.begin(), kEntries.end(), kinds.begin(),
                   [](const KindEntry& entry) { return entry.kind; });
    return kinds;
}();

const KindEntry& entryOf(const std::string& name) {
    const auto found = std::find_if(kEntries.begin(), kEntries.end(), [&](const KindEntry& entry) {
        return entry.kind.name == name;
    });
    if (found == kEntries.end())
        throw std::invalid_argument("no search is called " + name);
    return *found;
}

/// Sums over rays: integers, so that their order does not matter.
struct Counts {
    std::int64_t lookups = 0;
    int most = 0;
    int wrong = 0;
};

/// Ray number `index`, the same for every search and relief.
DescendingRay drawRay(const SearchBenchmarkOptions& options, double elevation, int index) {
    reference::RayNumbers numbers(options.seed, static_cast<std::uint64_t>(index));
    const double u = numbers.unit();
    const double v = numbers.unit();
    const double azimuth = 2.0 * std::numbers::pi * numbers.unit();
    return reference::descendingRay({u, v}, elevation * std::numbers::pi / 180.0, azimuth,
                                    options.depthScale, 1.0);
}

bool isWrong(const DepthMap& relief, const DescendingRay& ray, const MapSearchResult& result,
             double depthScale) {
    const double speed = ray.speed(relief.aspect());
    const auto hit =
        reference::traceBilinear(relief, {{ray.start, 0.0}, {ray.slope, 1.0}}, {}, speed + 1.0);
    if (!hit)  // cannot be: at depth 1 everything is solid
        throw std::logic_error("a ray that comes down met nothing");
    const double offAlongRay = std::abs(result.z - hit->position.z) * std::hypot(speed, depthScale);
    return !result.converged || offAlongRay > 1.0 / relief.width();
}

Counts searchRays(const DepthMap& relief, const Search& search, double elevation,
                  const SearchBenchmarkOptions& options) {
    const auto searchRange = [&](const tbb::blocked_range<int>& range, Counts counts) {
        for (int index = range.begin(); index != range.end(); ++index) {
            const DescendingRay ray = drawRay(options, elevation, index);
            const MapSearchResult result = search(relief, ray);
            counts.lookups += result.lookups;
            counts.most = std::max(counts.most, result.lookups);
            counts.wrong += isWrong(relief, ray, result, options.depthScale) ? 1 : 0;
        }
        return counts;
    };
    return tbb::parallel_reduce(
        tbb::blocked_range<int>(0, options.rays), Counts{}, searchRange,
        [](const Counts& a, const Counts& b) {
            return Counts{a.lookups + b.lookups, std::max(a.most, b.most), a.wrong + b.wrong};
        });
}

}  // namespace

std::span<const SearchKind> searchKinds() {
    return kKinds;
}

std::vector<SearchMeasurement> measureSearches(const SearchBenchmarkOptions& options) {
    commands::Progress progress(
        "searches", options.samples.size() * options.searches.size() * options.elevations.size());
    std::vector<SearchMeasurement> measurements;
    for (const std::string& sample : options.samples) {
        const DepthMap relief = textures::generateSampleRelief(sample, options.size, options.size);
        for (const std::string& name : options.searches) {
            const PreparedSearch prepared = entryOf(name).prepare(relief);
            for (const double elevation : options.elevations) {
                const Counts counts = searchRays(relief, prepared.search, elevation, options);
                measurements.push_back(
                    {sample, name, elevation, static_cast<double>(counts.lookups) / options.rays,
                     counts.most, static_cast<double>(counts.wrong) / options.rays,
                     prepared.meanRatio});
                progress.advance();
            }
        }
    }
    return measurements;
}

ReportTable searchTable(const std::vector<SearchMeasurement>& measurements) {
    ReportTable table;
    table.columns = {{"sample", "sample"},       {"search", "search"},
                     {"elevation", "elevation"}, {"meanLookups", "lookups"},
                     {"mostLookups", "most"},    {"wrongPercent", "wrong %", 3},
                     {"meanRatio", "mean ratio"}};
    for (const SearchMeasurement& m : measurements)
        table.rows.push_back({m.sample, m.search, m.elevation, m.meanLookups,
                              std::int64_t{m.mostLookups}, 100.0 * m.wrongShare,
                              m.meanRatio ? ReportCell(*m.meanRatio) : ReportCell()});
    return table;
}

Plot searchPlot(const std::vector<SearchMeasurement>& measurements) {
    Plot plot;
    plot.title = "Lookups to the hit";
    plot.xLabel = "degrees above the surface";
    plot.yLabel = "lookups of a ray";
    plot.keyPosition = "top right";
    for (const SearchMeasurement& m : measurements)
        seriesOf(plot, m.sample, m.search).points.emplace_back(m.elevation, m.meanLookups);
    return plot;
}

}  // namespace relievo::bench
