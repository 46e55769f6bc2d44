#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/report_table.h"

namespace relievo::bench {

/// What to measure: strokes of every brush on conservative cones that are kept up to date
/// (preprocess/bilinear_cones.h), on every sample relief.
struct EditBenchmarkOptions {
    std::vector<std::string> samples;  ///< names of textures::sampleReliefs
    int size = 1024;                   ///< the reliefs are size×size texels
    int strokes = 20;                  ///< on each sample, the brushes in turn
    int strokeSize = 32;               ///< a stroke covers strokeSize² texels; at most the relief
    std::uint32_t seed = 1;            ///< other places and other grain
};

/// The strokes of one brush on one sample.
struct EditMeasurement {
    std::string sample;
    std::string brush;
    int size = 0;
    int strokes = 0;
    double meanSeconds = 0.0;
    double worstSeconds = 0.0;
    double buildSeconds = 0.0;  ///< of all cones anew: the fastest time
    double meanTexels = 0.0;    ///< built anew by a stroke
    std::int64_t mostTexels = 0;
};

/// Measures sample by sample: `heap` and `dent` add and take a tenth of the depth, round and
/// smooth; `grain` adds noise of a hundredth; `copy` stamps another place of the relief; `peak`
/// raises a smooth peak to the reference surface; `undo` takes each of these back. One stroke on
/// each sample and the last undo are compared with cones built anew: throws std::logic_error unless
/// they are equal bit for bit.
std::vector<EditMeasurement> measureEdits(const EditBenchmarkOptions& options);

/// One row a measurement.
ReportTable editTable(const std::vector<EditMeasurement>& measurements);

}  // namespace relievo::bench
