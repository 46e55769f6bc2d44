#include "preprocess/view_displacement.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "preprocess/horizon_map.h"
#include "reference/bilinear_tracer.h"
#include "tests/preprocess/small_reliefs.h"
#include "tests/preprocess/thread_limit.h"
#include "textures/bilinear.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::WrapMode;
using Table = std::vector<Plane>;

constexpr WrapMode kWraps[] = {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};
constexpr std::pair<int, int> kSizes[] = {{1, 1},  {1, 7},  {8, 1}, {2, 2},
                                          {11, 7}, {64, 1}, {12, 9}};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// One entry of a table.
struct Entry {
    int i;
    int j;
    int azimuth;
    int elevation;
    int curvature;
};

template <typename Use>
void forAllEntries(const DepthMap& map, const ViewGrid& grid, const Use& use) {
    for (int curvature = 0; curvature < grid.curvatures; ++curvature)
        for (int elevation = 0; elevation < grid.elevations; ++elevation)
            for (int azimuth = 0; azimuth < grid.azimuths; ++azimuth)
                for (int j = 0; j < map.height(); ++j)
                    for (int i = 0; i < map.width(); ++i)
                        use(Entry{i, j, azimuth, elevation, curvature});
}

double distanceAt(const Table& table, const ViewGrid& grid, const Entry& entry) {
    const Plane& plane = table[grid.view(entry.azimuth, entry.elevation, entry.curvature)];
    return static_cast<double>(plane.at(entry.i, entry.j));
}

// The ray of an entry over the curved base, by the definition and nothing else.
class Ray {
  public:
    Ray(const DepthMap& map, const ViewGrid& grid, const Entry& entry)
        : map_(map),
          scale_(grid.depthScale),
          azimuth_(azimuthOf(entry.azimuth, grid.azimuths)),
          elevation_(grid.elevationOf(entry.elevation)),
          curvature_(grid.curvatureOf(entry.curvature)),
          u_((entry.i + 0.5) / map.width()),
          v_((entry.j + 0.5) / map.height()) {}

    // How far below the surface it is after `distance`, in tile widths.
    [[nodiscard]] double below(double distance) const {
        const double s = distance * std::cos(elevation_);
        const double depth = distance * std::sin(elevation_) - curvature_ * s * s / 2.0;
        return depth - scale_ * sampleBilinear(map_.depth, u_ + s * std::cos(azimuth_),
                                               v_ + s * std::sin(azimuth_) / map_.aspect(),
                                               map_.wrap);
    }
    // The distance at which it comes out of the reference surface again.
    [[nodiscard]] double exit() const {
        const double across = std::cos(elevation_);
        return curvature_ > 0.0 ? 2.0 * std::sin(elevation_) / (curvature_ * across * across)
                                : kInfinity;
    }

  private:
    const DepthMap& map_;
    double scale_;
    double azimuth_;
    double elevation_;
    double curvature_;
    double u_;
    double v_;
};

// Whether the ray is above the surface before `distance`, and if that is a hit on the surface
// there.
bool isFirstHit(const Ray& ray, double distance) {
    constexpr int kSamples = 150;
    constexpr double kTolerance = 1e-5;  // a float's part of a distance, times a steep slope
    const bool isHit = distance != static_cast<double>(kNoHit);
    const double end = isHit ? distance : ray.exit();
    if (end == kInfinity)
        return false;  // every ray meets a base that does not fall away
    for (int k = 0; k < kSamples; ++k)
        if (ray.below(end * k / kSamples) > 1e-9)
            return false;
    return !isHit || (distance >= 0.0 && distance <= ray.exit() &&
                      std::abs(ray.below(distance)) <= kTolerance && ray.below(distance) <= 1e-12);
}

int countWrong(const DepthMap& map, const ViewGrid& grid, const Table& table) {
    int wrong = 0;
    forAllEntries(map, grid, [&](const Entry& entry) {
        wrong += isFirstHit(Ray(map, grid, entry), distanceAt(table, grid, entry)) ? 0 : 1;
    });
    return wrong;
}

ViewGrid smallGrid() {
    ViewGrid grid;
    grid.azimuths = 5;
    grid.elevations = 4;
    grid.depthScale = 0.3;
    return grid;
}

TEST(ViewDisplacement, OverAPlaneIsTheExactFirstHit) {
    ViewGrid grid = smallGrid();
    grid.azimuths = 12;  // along both axes and a diagonal, too
    grid.curvatures = 1;
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : kSizes)
            for (const DepthMap& map :
                 {noiseMap(width, height, wrap, 5), hillMap(width, height, wrap, 0.7)}) {
                const Table table = buildViewDisplacement(map, grid);
                forAllEntries(map, grid, [&](const Entry& entry) {
                    const double azimuth = azimuthOf(entry.azimuth, grid.azimuths);
                    const double elevation = grid.elevationOf(entry.elevation);
                    const double across = std::cos(elevation);
                    const reference::TileRay ray{
                        {(entry.i + 0.5) / width, (entry.j + 0.5) / height, 0.0},
                        {across * std::cos(azimuth), across * std::sin(azimuth) / map.aspect(),
                         std::sin(elevation) / grid.depthScale}};
                    const auto hit = reference::traceBilinear(map, ray);
                    ASSERT_TRUE(hit);
                    const double distance = distanceAt(table, grid, entry);
                    ASSERT_LE(distance, hit->t * (1.0 + 1e-14));
                    ASSERT_GE(distance, hit->t * (1.0 - 2e-7) - 1e-14)
                        << width << "x" << height << " " << entry.i << "," << entry.j << " azimuth "
                        << entry.azimuth << " elevation " << entry.elevation;
                });
            }
}

TEST(ViewDisplacement, OverCurvedBasesIsTheFirstHitAndNeverBehindIt) {
    const ViewGrid grid = smallGrid();
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : kSizes)
            for (const DepthMap& map :
                 {noiseMap(width, height, wrap, 6), hillMap(width, height, wrap, 1.4)})
                EXPECT_EQ(countWrong(map, grid, buildViewDisplacement(map, grid)), 0)
                    << width << "x" << height << " " << wrapModeName(wrap);
}

TEST(ViewDisplacement, TheCheckFindsWrongTables) {
    const ViewGrid grid = smallGrid();
    const DepthMap map = hillMap(12, 9, WrapMode::Repeat);
    ViewGrid straight = grid;
    straight.sharpest = 0.0;
    EXPECT_GT(countWrong(map, grid, buildViewDisplacement(map, straight)), 0) << "no curvature";
    ViewGrid deep = grid;
    deep.depthScale *= 1.001;
    EXPECT_GT(countWrong(map, grid, buildViewDisplacement(map, deep)), 0) << "another scale";
    DepthMap mirrored = map;
    mirrored.wrap = WrapMode::Mirror;
    EXPECT_GT(countWrong(map, grid, buildViewDisplacement(mirrored, grid)), 0) << "wrong wrap mode";
    Table behind = buildViewDisplacement(map, grid);
    for (Plane& plane : behind)
        for (float& distance : plane.texels)
            if (distance != kNoHit)
                distance = std::nextafter(distance, std::numeric_limits<float>::infinity());
    EXPECT_GT(countWrong(map, grid, behind), 0) << "rounded up";
    Table silhouettes = buildViewDisplacement(map, grid);
    for (Plane& plane : silhouettes)
        for (float& distance : plane.texels)
            distance = std::max(distance, 0.0f);
    EXPECT_GT(countWrong(map, grid, silhouettes), 0) << "hits where there are none";
}

TEST(ViewDisplacement, OfAPlainIsTheRootOfAParabola) {
    ViewGrid grid = smallGrid();
    grid.elevations = 9;
    const DepthMap map{Plane(3, 2, 0.75f), WrapMode::Mirror};
    const Table table = buildViewDisplacement(map, grid);
    int misses = 0;
    forAllEntries(map, grid, [&](const Entry& entry) {
        const double depth = 0.75 * grid.depthScale;
        const double elevation = grid.elevationOf(entry.elevation);
        const double curvature = grid.curvatureOf(entry.curvature);
        const double tangent = std::tan(elevation);
        const double discriminant = tangent * tangent - 2.0 * curvature * depth;
        const double truth =
            discriminant < 0.0
                ? static_cast<double>(kNoHit)
                : 2.0 * depth / (tangent + std::sqrt(discriminant)) / std::cos(elevation);
        misses += discriminant < 0.0 ? 1 : 0;
        EXPECT_NEAR(distanceAt(table, grid, entry), truth, 1e-6);
    });
    EXPECT_GT(misses, 0);
}

// Three times as deep, with three times the tangent (60° for 30°) and curvature, is the same place.
TEST(ViewDisplacement, ServesOtherScales) {
    ViewGrid grid = smallGrid();
    grid.elevations = 3;
    ViewGrid deep = grid;
    deep.depthScale *= 3.0;
    deep.sharpest *= 3.0;
    const DepthMap map = noiseMap(9, 6, WrapMode::Repeat, 8);
    const Table table = buildViewDisplacement(map, grid);
    const Table deepTable = buildViewDisplacement(map, deep);
    forAllEntries(map, grid, [&](const Entry& entry) {
        if (entry.elevation != 0)
            return;
        Entry steep = entry;
        steep.elevation = 1;
        const double distance = distanceAt(table, grid, entry);
        const double other = distanceAt(deepTable, deep, steep);
        ASSERT_EQ(distance < 0.0, other < 0.0);
        ASSERT_NEAR(distance, distance < 0.0 ? distance : other / std::sqrt(3.0), 1e-6);
    });
}

TEST(ViewDisplacement, OnTheReferenceSurfaceIsNothing) {
    const DepthMap map{Plane(2, 5, 0.0f), WrapMode::Repeat};
    for (const Plane& plane : buildViewDisplacement(map, smallGrid()))
        for (const float distance : plane.texels)
            EXPECT_EQ(distance, 0.0f);
}

// What the depths of a circle and of the parabola differ by over the arc.
TEST(ViewDisplacement, TheParabolaIsTheCircleToSecondOrder) {
    for (const double curvature : {-0.3, 0.2, 1.0})
        for (const double elevation : {0.1, 0.7, 1.3})
            for (const double distance : {0.02, 0.1, 0.3}) {
                const double radius = 1.0 / curvature;
                const double across = distance * std::cos(elevation);
                const double down = distance * std::sin(elevation);
                const double circle =
                    radius - std::copysign(std::hypot(across, radius - down), radius);
                const double parabola = down - curvature * across * across / 2.0;
                EXPECT_NEAR(circle, parabola, curvature * curvature * std::pow(distance, 3));
            }
}

TEST(ViewDisplacement, IsThatOfTheMosaic) {
    const ViewGrid grid = smallGrid();
    ViewGrid wide = grid;  // whose unit is three tiles
    wide.depthScale /= 3;
    wide.sharpest *= 3;
    for (const WrapMode wrap : kWraps) {
        const DepthMap map = noiseMap(9, 5, wrap, 9);
        const Table table = buildViewDisplacement(map, grid);
        const Table mosaic = buildViewDisplacement(mosaicOf(map, 1), wide);
        for (std::size_t view = 0; view < table.size(); ++view)
            for (int j = 0; j < 5; ++j)
                for (int i = 0; i < 9; ++i) {
                    const float distance = table[view].at(i, j);
                    const float expected = mosaic[view].at(i + 9, j + 5);
                    ASSERT_EQ(distance == kNoHit, expected == kNoHit);
                    ASSERT_NEAR(distance, distance == kNoHit ? kNoHit : 3.0f * expected, 1e-6f);
                }
    }
}

TEST(ViewDisplacement, IsTheSameForOneAndTwoThreadsAndTellsOfAllTexels) {
    const DepthMap map = noiseMap(30, 20, WrapMode::Clamp, 5);
    std::atomic<std::size_t> texels = 0;
    const auto build = [&] {
        return buildViewDisplacement(map, smallGrid(), [&](std::size_t done) { texels += done; });
    };
    const Table one = onThreads(1, build);
    EXPECT_EQ(texels, 30u * 20u);
    const Table two = onThreads(2, build);
    for (std::size_t view = 0; view < one.size(); ++view)
        EXPECT_EQ(one[view].texels, two[view].texels);
}

}  // namespace
}  // namespace relievo::preprocess
