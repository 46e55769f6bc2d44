#pragma once

#include <string>
#include <vector>

#include "bench/gnuplot.h"
#include "bench/report_table.h"
#include "gl/context.h"
#include "viewer/measured_frame.h"
#include "viewer/picture.h"
#include "viewer/temporal_error.h"

namespace relievo::bench {

/// A plane that recedes to the horizon, seen by a camera that turns slowly, by parts of a pixel a
/// frame: with and without MIP levels, with one ray a pixel and with several, against supersampled
/// exact hits.
struct SparkleBenchmarkOptions {
    std::vector<std::string> samples;                        ///< names of textures::sampleReliefs
    std::vector<std::string> techniques{"relief", "exact"};  ///< names of the technique registry
    int frames = 12;                                         ///< ≥ 2
    int size = 128;                                          ///< the reliefs are size×size texels
    int frame = 128;                                         ///< the frames are frame×frame pixels
    int rays = 4;           ///< in a pixel, where there are several
    int supersampling = 8;  ///< the truth has as many samples a pixel along each axis
    int tiles = 64;         ///< across the plane
    double depthScale = 0.1;
    double elevation = 12.0;  ///< degrees by which the middle of the frame is below the horizon
    int repeat = 1;           ///< runs of which the fastest counts
    gl::Backend backend = gl::Backend::OSMesa;
};

struct SparkleMeasurement {
    std::string sample;
    std::string technique;
    bool hasLevels = false;
    int rays = 1;  ///< the most in a pixel
    viewer::TemporalErrorStatistics errors;
    viewer::WorkCounts work;  ///< of the first frame
    double seconds = 0.0;     ///< of the fastest run of it
    viewer::Picture picture;  ///< the first frame
};

struct SparkleReport {
    std::string renderer;  ///< of OpenGL
    std::vector<SparkleMeasurement> measurements;
    std::vector<viewer::Picture> truths;  ///< of the first frame, one a sample
};

/// Measures sample by sample, technique by technique: one ray without levels and with them, then
/// several. Throws gl::GlError when there is no context.
SparkleReport measureSparkle(const SparkleBenchmarkOptions& options);

/// One row a measurement; luminances in per cent of white.
ReportTable sparkleTable(const std::vector<SparkleMeasurement>& measurements);

/// The same, each number its mean over the samples.
ReportTable meanSparkleTable(const std::vector<SparkleMeasurement>& measurements);

/// Sparkle against time: a panel a sample, a curve a technique.
Plot sparklePlot(const std::vector<SparkleMeasurement>& measurements);

}  // namespace relievo::bench
