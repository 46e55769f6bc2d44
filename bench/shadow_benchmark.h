#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/gnuplot.h"
#include "bench/markdown.h"
#include "bench/report_table.h"
#include "gl/context.h"
#include "viewer/light_errors.h"

namespace relievo::bench {

/// Names no shadow method among those to be measured: what is lit without shadows.
inline constexpr const char* kNoShadow = "none";

/// What to measure: every method of self-shadowing on every sample relief, repeated without end,
/// seen by parallel rays, under lights of every elevation and size.
struct ShadowBenchmarkOptions {
    std::vector<std::string> samples;        ///< names of textures::sampleReliefs
    std::vector<std::string> methods;        ///< names of the shadow registry, or kNoShadow
    std::string technique = "exact";         ///< of the registry: finds what is seen
    std::vector<double> elevations{45, 15};  ///< of the light, in degrees
    std::vector<double> lightSizes{0, 10};   ///< what it spans in degrees; 0 is a point
    std::vector<int> budgets{1, 2, 4, 8};    ///< for methods that have one (budgetParameter)
    int size = 256;                          ///< the reliefs are size×size texels
    int frame = 151;                         ///< the frames are frame×frame pixels, of one tile
    int lightRays = 128;                     ///< exact rays to a light that is no point
    int repeat = 3;                          ///< runs of which the fastest counts
    double viewElevation = 60.0;             ///< of the rays above the surface, in degrees
    double depthScale = 0.1;
    gl::Backend backend = gl::Backend::OSMesa;
};

struct ShadowMeasurement {
    std::string sample;
    std::string method;
    std::optional<int> budget;  ///< nothing for a method without one
    double elevation = 0.0;     ///< of the light
    double lightSize = 0.0;
    viewer::LightErrors errors;  ///< against the exact visibility of the same points
    double seconds = 0.0;        ///< of the fastest shaded frame
};

/// What was measured, and on what.
struct ShadowReport {
    std::string renderer;  ///< of OpenGL
    std::vector<ShadowMeasurement> measurements;
};

/// Measures sample by sample, light by light, method by method. Throws gl::GlError when there is no
/// context and textures::InputError when the technique cannot search light rays.
ShadowReport measureShadows(const ShadowBenchmarkOptions& options);

/// One row a measurement; shares in per cent.
ReportTable shadowTable(const std::vector<ShadowMeasurement>& measurements);

/// Over all reliefs, of each method under each light: wrong pixels on the worst relief and their
/// mean, the mean error, lookups and time.
std::vector<ReportSection> summariseShadows(const std::vector<ShadowMeasurement>& measurements);

/// Wrong pixels against time, means over the reliefs: a panel a light, a curve a method.
Plot shadowPlot(const std::vector<ShadowMeasurement>& measurements);

}  // namespace relievo::bench
