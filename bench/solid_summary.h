#pragma once

#include <vector>

#include "bench/markdown.h"
#include "bench/solid_benchmark.h"

namespace relievo::bench {

/// What there is to read from many measurements, means over the shapes: what each search of solids
/// gets wrong with its defaults, and how; wrong first hits, lookups and time at every elevation;
/// what our search takes of the lookups and the time of every other one at equal error; and what it
/// takes of profiles against upright walls.
std::vector<ReportSection> summariseSolids(const std::vector<SolidMeasurement>& measurements);

/// The lookups of `ours` over those of `theirs`, both searches of one solid and shape from one
/// elevation with several budgets, at equal error: theirs with the least lookups with which it is
/// within a fiftieth of the fewest wrong hits that it comes to, ours with the least with which it
/// has no more wrong ones. Nothing when ours never does.
std::optional<double> fetchesAtEqualError(const std::vector<SolidMeasurement>& ours,
                                          const std::vector<SolidMeasurement>& theirs);

/// Likewise, each with the least lookups with which at most `wrongShare` (0 to 1) of the rays are
/// wrong; infinite when ours never has so few. Nothing when theirs never does.
std::optional<double> fetchesWithin(const std::vector<SolidMeasurement>& ours,
                                    const std::vector<SolidMeasurement>& theirs, double wrongShare);

}  // namespace relievo::bench
