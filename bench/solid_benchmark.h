#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/gnuplot.h"
#include "bench/render_benchmark.h"
#include "bench/report_table.h"
#include "bench/solid_truth.h"
#include "gl/context.h"
#include "reference/error_metrics.h"
#include "viewer/measured_frame.h"

namespace relievo::bench {

/// Searches of solids (materials::solidTechniques), then the searches of reliefs that show the same
/// extrusions as height maps.
std::vector<std::string> solidBenchmarkTechniques();

/// What to measure: every solid of every shape that fits it, under parallel rays from every
/// elevation, with every search that shows it at every step budget and with its defaults.
/// Extrusions are sunk into a plane and repeated without end, with a floor; revolutions stand in
/// their box.
struct SolidBenchmarkOptions {
    std::vector<std::string> solids;               ///< of solidModelNames
    std::vector<std::string> shapes;               ///< of solidShapeNames
    std::vector<std::string> techniques;           ///< of solidBenchmarkTechniques
    std::vector<double> elevations{45, 15, 5, 1};  ///< degrees above the plane
    /// Dense where ours goes through its errors, and up to where linear searches stop getting
    /// better at 1°: a ray goes through 3666 texels there.
    std::vector<int> steps{1,  2,  3,   4,   6,   8,    12,   16,   24,
                           32, 64, 128, 256, 512, 1024, 2048, 4096, 8192};
    std::vector<int> sizes{256};  ///< the shape maps are size×size texels
    int frame = 201;              ///< pixels of the frames on a side
    int repeat = 3;               ///< runs of which the fastest counts
    double depthScale = 0.25;     ///< of extrusions, in tile widths
    double azimuth = 35.0;        ///< degrees
    /// "round", as all searches see the maps, or "sharp", with creases, which only ours reads.
    std::string corners = "round";
    gl::Backend backend = gl::Backend::OSMesa;
};

struct SolidMeasurement {
    std::string solid;
    std::string shape;
    std::string technique;
    bool isRelief = false;  ///< the solid was shown as a height map
    double elevation = 0.0;
    std::optional<int> steps;  ///< the step budget; nothing for a technique without one
    bool isDefault = false;    ///< it is the default one
    int size = 0;
    double seconds = 0.0;  ///< of the fastest shaded frame
    viewer::WorkCounts work;
    /// Against the first hits of the same rays with the solid that the shape map defines, whatever
    /// it was shown as. Normals are not compared.
    reference::ErrorStatistics errors;
    SolidFaults faults;
    double tiedShare = 0.0;  ///< of rays that only rounding decides, and that are right
};

struct SolidReport {
    std::string renderer;  ///< of OpenGL
    std::vector<SolidMeasurement> measurements;
};

/// Measures solid by solid, shape by shape, elevation by elevation, technique by technique. A first
/// hit is wrong when it is off by over a texel along the ray. Throws gl::GlError when there is no
/// context.
SolidReport measureSolids(const SolidBenchmarkOptions& options);

/// One row a measurement; distances in texels, shares in per cent.
ReportTable solidTable(const std::vector<SolidMeasurement>& measurements);

/// Wrong first hits against time or fetches, means over shapes and elevations: a panel a solid, a
/// curve a technique.
Plot solidPlot(const std::vector<SolidMeasurement>& measurements, PlotAgainst against);

}  // namespace relievo::bench
