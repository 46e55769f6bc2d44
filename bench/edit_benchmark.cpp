#include "bench/edit_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "bench/stopwatch.h"
#include "commands/progress.h"
#include "preprocess/bilinear_cones.h"
#include "textures/sample_reliefs.h"

namespace relievo::bench {

namespace {

using preprocess::BilinearCones;
using textures::DepthMap;
using textures::Plane;

/// A square of texels.
struct Place {
    int left;
    int top;
    int size;
};

Place drawPlace(const DepthMap& map, int size, std::mt19937& numbers) {
    const auto below = [&](int limit) {
        return static_cast<int>(numbers() % static_cast<std::uint32_t>(limit));
    };
    const int left = below(map.width() - size + 1);
    return {left, below(map.height() - size + 1), size};
}

Plane depthsAt(const DepthMap& map, const Place& place) {
    Plane depths(place.size, place.size);
    for (int j = 0; j < place.size; ++j)
        for (int i = 0; i < place.size; ++i)
            depths.at(i, j) = map.depth.at(place.left + i, place.top + j);
    return depths;
}

/// 1 in the middle of a stroke, falling smoothly to 0 at its circle.
float falloff(int i, int j, int size) {
    const double middle = (size - 1) / 2.0;
    const double radius = std::hypot(i - middle, j - middle) / (size / 2.0);
    return static_cast<float>(0.5 + 0.5 * std::cos(std::numbers::pi * std::min(radius, 1.0)));
}

/// Depths after a stroke of which change(depth, falloff) is the depth of each texel.
template <typename Change>
Plane strokeOf(const DepthMap& map, const Place& place, const Change& change) {
    Plane depths = depthsAt(map, place);
    for (int j = 0; j < place.size; ++j)
        for (int i = 0; i < place.size; ++i)
            depths.at(i, j) =
                std::clamp(change(depths.at(i, j), falloff(i, j, place.size)), 0.0f, 1.0f);
    return depths;
}

Plane heap(const DepthMap& map, const Place& place, std::mt19937&) {
    return strokeOf(map, place, [](float depth, float share) { return depth - 0.1f * share; });
}

Plane dent(const DepthMap& map, const Place& place, std::mt19937&) {
    return strokeOf(map, place, [](float depth, float share) { return depth + 0.1f * share; });
}

Plane grain(const DepthMap& map, const Place& place, std::mt19937& numbers) {
    return strokeOf(map, place, [&](float depth, float) {
        return depth + 0.01f * (static_cast<float>(numbers() % 256) / 255.0f - 0.5f);
    });
}

Plane copy(const DepthMap& map, const Place& place, std::mt19937& numbers) {
    return depthsAt(map, drawPlace(map, place.size, numbers));
}

Plane peak(const DepthMap& map, const Place& place, std::mt19937&) {
    return strokeOf(map, place, [](float depth, float share) { return depth * (1.0f - share); });
}

struct Brush {
    const char* name;
    Plane (*stroke)(const DepthMap& map, const Place& place, std::mt19937& numbers);
};

constexpr std::array kBrushes{Brush{"heap", heap}, Brush{"dent", dent}, Brush{"grain", grain},
                              Brush{"copy", copy}, Brush{"peak", peak}};

/// All that is measured on one sample: a row a brush, and one for undoing.
class EditedSample {
  public:
    EditedSample(const std::string& sample, const EditBenchmarkOptions& options)
        : sample_(sample),
          cones_(textures::generateSampleRelief(sample, options.size, options.size)) {
        for (const Brush& brush : kBrushes)
            rows_.push_back({.sample = sample, .brush = brush.name, .size = options.size});
        rows_.push_back({.sample = sample, .brush = "undo", .size = options.size});
    }

    [[nodiscard]] const DepthMap& map() const { return cones_.map(); }

    void stroke(std::size_t brush, const Place& place, std::mt19937& numbers) {
        before_ = depthsAt(cones_.map(), place);
        place_ = place;
        edit(rows_[brush], kBrushes[brush].stroke(cones_.map(), place, numbers));
    }

    void undo() { edit(rows_.back(), before_); }

    // Builds all cones anew, which is timed as well.
    void compareWithNewBuild() {
        const DepthMap& map = cones_.map();
        Plane anew;
        buildSeconds_ =
            std::min(buildSeconds_, secondsOf([&] { anew = BilinearCones(map).ratio(); }));
        if (anew.texels != cones_.ratio().texels)
            throw std::logic_error(fmt::format(
                "the cones of {} after a stroke are not those of a new build", sample_));
    }

    [[nodiscard]] std::vector<EditMeasurement> rows() const {
        std::vector<EditMeasurement> rows = rows_;
        for (EditMeasurement& row : rows) {
            row.meanSeconds /= std::max(1, row.strokes);
            row.meanTexels /= std::max(1, row.strokes);
            row.buildSeconds = buildSeconds_;
        }
        return rows;
    }

  private:
    // Means are sums until rows() divides them.
    void edit(EditMeasurement& row, const Plane& depths) {
        std::size_t texels = 0;
        const double seconds =
            secondsOf([&] { texels = cones_.edit(place_.left, place_.top, depths); });
        ++row.strokes;
        row.meanSeconds += seconds;
        row.worstSeconds = std::max(row.worstSeconds, seconds);
        row.meanTexels += static_cast<double>(texels);
        row.mostTexels = std::max(row.mostTexels, static_cast<std::int64_t>(texels));
    }

    std::string sample_;
    BilinearCones cones_;
    std::vector<EditMeasurement> rows_;
    Plane before_;
    Place place_{};
    double buildSeconds_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<EditMeasurement> measureEdits(const EditBenchmarkOptions& options) {
    const auto strokes = static_cast<std::size_t>(options.strokes);
    commands::Progress progress("strokes", options.samples.size() * strokes);
    std::vector<EditMeasurement> measurements;
    for (std::size_t k = 0; k < options.samples.size(); ++k) {
        EditedSample sample(options.samples[k], options);
        std::mt19937 numbers(options.seed);
        const std::size_t compared = k % std::min(strokes, kBrushes.size());  // another brush each
        for (std::size_t stroke = 0; stroke < strokes; ++stroke) {
            const int size = std::min(options.strokeSize, options.size);
            sample.stroke(stroke % kBrushes.size(), drawPlace(sample.map(), size, numbers),
                          numbers);
            if (stroke == compared)
                sample.compareWithNewBuild();
            sample.undo();
            progress.advance();
        }
        sample.compareWithNewBuild();
        for (EditMeasurement& row : sample.rows())
            if (row.strokes > 0)
                measurements.push_back(std::move(row));
    }
    return measurements;
}

ReportTable editTable(const std::vector<EditMeasurement>& measurements) {
    ReportTable table;
    table.columns = {{"sample", "sample"},
                     {"brush", "brush"},
                     {"size", "size"},
                     {"strokes", "strokes"},
                     {"meanMilliseconds", "mean ms"},
                     {"worstMilliseconds", "worst ms"},
                     {"buildMilliseconds", "all anew ms"},
                     {"meanShare", "mean share"},
                     {"worstShare", "worst share"},
                     {"meanTexels", "mean texels"},
                     {"mostTexels", "most texels"}};
    for (const EditMeasurement& m : measurements)
        table.rows.push_back({m.sample, m.brush, std::int64_t{m.size}, std::int64_t{m.strokes},
                              1e3 * m.meanSeconds, 1e3 * m.worstSeconds, 1e3 * m.buildSeconds,
                              m.meanSeconds / m.buildSeconds, m.worstSeconds / m.buildSeconds,
                              m.meanTexels, m.mostTexels});
    return table;
}

}  // namespace relievo::bench
