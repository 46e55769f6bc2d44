#pragma once

#include <vector>

#include "bench/markdown.h"
#include "bench/render_benchmark.h"

namespace relievo::bench {

/// What there is to read from many measurements: over all samples, wrong first hits (mean and
/// worst), mean distance from the exact hit, lookups, time and difference of the picture of each
/// technique and budget at every elevation; the least lookups and time with which a technique is
/// wrong on at most 0.1 % of the pixels; and the wrong first hits on each sample at the lowest
/// elevation.
std::vector<ReportSection> summariseRender(const std::vector<RenderMeasurement>& measurements);

}  // namespace relievo::bench
