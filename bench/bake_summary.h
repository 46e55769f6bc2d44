#pragma once

#include <vector>

#include "bench/bake_benchmark.h"
#include "bench/edit_benchmark.h"
#include "bench/markdown.h"
#include "bench/search_benchmark.h"

namespace relievo::bench {

/// The size at which builders are compared: 1024 if it is among those measured, else the largest.
int sizeForComparison(const std::vector<int>& sizes);

/// What there is to read from many measurements: speed at every size; on every sample at the size
/// for comparison; growth of the time per texel with the size; how many times faster than the
/// baselines of the same product; mean ratios; memory beside what relievo-bake counts on. Tables
/// without rows are left out.
std::vector<ReportSection> summariseBake(const std::vector<BakeMeasurement>& measurements);

/// Strokes over all brushes of each sample, and over all samples of each brush.
std::vector<ReportSection> summariseEdits(const std::vector<EditMeasurement>& measurements);

/// Over all samples: mean ratio, mean lookups and wrong hits of each search at every elevation.
std::vector<ReportSection> summariseSearches(const std::vector<SearchMeasurement>& measurements);

}  // namespace relievo::bench
