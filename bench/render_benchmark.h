#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/gnuplot.h"
#include "bench/report_table.h"
#include "gl/context.h"
#include "materials/slope_sources.h"
#include "reference/error_metrics.h"
#include "viewer/measured_frame.h"

namespace relievo::bench {

/// What to measure: every technique at every step budget, on every sample relief, repeated without
/// end, under parallel rays from every elevation.
struct RenderBenchmarkOptions {
    std::vector<std::string> samples;                  ///< names of textures::sampleReliefs
    std::vector<std::string> techniques;               ///< names of the technique registry
    std::vector<double> elevations{90, 45, 15, 5, 1};  ///< degrees above the surface
    std::vector<int> steps{8, 16, 32, 64, 128, 256};
    int size = 256;  ///< the reliefs are size×size texels
    /// The frames are frame×frame pixels, which show one tile. By default no divisor or multiple of
    /// the size, so that rays meet the texels at all places and not at their centres only.
    int frame = 301;
    int repeat = 3;  ///< runs of which the fastest counts
    double depthScale = 0.1;
    double azimuth = 35.0;                          ///< degrees
    std::optional<materials::SlopeSource> normals;  ///< where slopes come from; none: derivatives
    gl::Backend backend = gl::Backend::OSMesa;
};

struct RenderMeasurement {
    std::string sample;
    std::string technique;
    double elevation = 0.0;
    std::optional<int> steps;  ///< the step budget; nothing for a technique without one
    int size = 0;
    double seconds = 0.0;  ///< of the fastest shaded frame
    viewer::WorkCounts work;
    reference::ErrorStatistics errors;  ///< against the exact hits of the same rays
    /// Mean difference of the shaded frame from that of the exact hits, over pixels and colours; 1
    /// is white against black.
    double pictureDifference = 0.0;
};

/// What was measured, and on what.
struct RenderReport {
    std::string renderer;  ///< of OpenGL
    std::vector<RenderMeasurement> measurements;
};

/// Measures sample by sample, elevation by elevation, technique by technique. A first hit is wrong
/// when it is off by over a texel along the ray. Throws gl::GlError when there is no context.
RenderReport measureRender(const RenderBenchmarkOptions& options);

/// One row a measurement; distances in texels, shares in per cent.
ReportTable renderTable(const std::vector<RenderMeasurement>& measurements);

/// What the errors are plotted against.
enum class PlotAgainst { Time, Fetches };

/// Errors, means over the samples: a row of panels for the share of wrong first hits and one for
/// the distance from the exact hit, a panel an elevation, a curve a technique.
Plot renderPlot(const std::vector<RenderMeasurement>& measurements, PlotAgainst against);

}  // namespace relievo::bench
