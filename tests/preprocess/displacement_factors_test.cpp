#include "preprocess/displacement_factors.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "preprocess/displacement_error.h"
#include "preprocess/view_displacement.h"
#include "tests/preprocess/small_reliefs.h"
#include "tests/preprocess/thread_limit.h"

namespace relievo::preprocess {
namespace {

using textures::DepthMap;
using textures::Plane;
using textures::StorageFormat;
using textures::WrapMode;
using Table = std::vector<Plane>;

ViewGrid smallGrid() {
    ViewGrid grid;
    grid.azimuths = 6;
    grid.elevations = 4;
    grid.depthScale = 0.3;
    return grid;
}

// The errors over all hits of the table as it was built, in ascending order.
std::vector<double> errorsOf(const Table& built, const ViewGrid& grid,
                             const DisplacementFactors& factors) {
    std::vector<double> errors;
    for (std::size_t view = 0; view < built.size(); ++view)
        for (std::size_t texel = 0; texel < built[view].texels.size(); ++texel)
            if (const float distance = built[view].texels[texel]; distance != kNoHit)
                errors.push_back(std::abs(displacementOf(factors, grid, view, texel) - distance));
    std::sort(errors.begin(), errors.end());
    return errors;
}

void expectMeasured(const DisplacementError& measured, const std::vector<double>& errors) {
    double sum = 0.0;
    for (const double error : errors)
        sum += error;
    const double percentile = errors[(errors.size() * 99 + 99) / 100 - 1];
    EXPECT_EQ(measured.greatest, errors.back());
    EXPECT_NEAR(measured.mean, sum / static_cast<double>(errors.size()), 1e-6 * measured.mean);
    EXPECT_GE(measured.percentile99, percentile * (1.0 - 1e-6));
    EXPECT_LE(measured.percentile99, percentile * 1.01);
}

TEST(DisplacementFactors, ErrorsAreThoseOfAllHits) {
    const ViewGrid grid = smallGrid();
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {7, 5}, {24, 16}})
        for (const StorageFormat format : {StorageFormat::Float, StorageFormat::Half}) {
            const DepthMap map = noiseMap(width, height, WrapMode::Mirror, 4);
            const Table built = buildViewDisplacement(map, grid);
            Table table = built;
            const DisplacementFactors factors = factorDisplacement(table, grid, 6, format);
            const DisplacementError measured = measureFactors(table, grid, factors);
            expectMeasured(measured, errorsOf(built, grid, factors));
            DisplacementFactors fewer = factors;
            fewer.factors.front().texels.front() += 2.0f * fewer.factors.front().texels.front();
            EXPECT_GT(errorsOf(built, grid, fewer).back(), measured.greatest) << "a wrong factor";
        }
}

TEST(DisplacementFactors, SilhouettesAreKeptExactly) {
    const ViewGrid grid = smallGrid();
    const DepthMap map = hillMap(13, 8, WrapMode::Repeat);
    const Table built = buildViewDisplacement(map, grid);
    Table table = built;
    const DisplacementFactors factors = factorDisplacement(table, grid, 3, StorageFormat::Float);
    ASSERT_EQ(factors.misses.size(), missesPlanes(grid));
    std::size_t missing = 0;
    for (int curvature = 0; curvature < grid.curvatures; ++curvature)
        for (int elevation = 0; elevation < grid.elevations; ++elevation)
            for (int azimuth = 0; azimuth < grid.azimuths; ++azimuth)
                for (std::size_t texel = 0; texel < map.depth.texels.size(); ++texel) {
                    const bool misses =
                        built[grid.view(azimuth, elevation, curvature)].texels[texel] == kNoHit;
                    missing += misses ? 1 : 0;
                    ASSERT_EQ(
                        misses,
                        curvature > grid.curvatures / 2 &&
                            factors.misses[missesPlane(grid, azimuth, curvature)].texels[texel] >
                                static_cast<float>(elevation));
                }
    EXPECT_GT(missing, 0u);
}

TEST(DisplacementFactors, AsManyTermsAsTheRankLeaveNothing) {
    const ViewGrid grid = smallGrid();
    const DepthMap map = noiseMap(5, 4, WrapMode::Repeat, 3);
    Table table = buildViewDisplacement(map, grid);
    const DisplacementFactors all = factorDisplacement(table, grid, 25, StorageFormat::Float);
    EXPECT_LT(measureFactors(table, grid, all).greatest, 1e-6);
    EXPECT_EQ(all.factors.size(), 25u * 6u);
    EXPECT_EQ(all.factors.back().texels, std::vector<float>(20, 0.0f)) << "20 columns, 25 terms";
    Table plain = buildViewDisplacement({Plane(6, 5, 0.5f), WrapMode::Repeat}, grid);
    const DisplacementFactors one = factorDisplacement(plain, grid, 1, StorageFormat::Float);
    EXPECT_LT(measureFactors(plain, grid, one).greatest, 1e-6);
    Table nothing = buildViewDisplacement({Plane(6, 5, 0.0f), WrapMode::Repeat}, grid);
    const DisplacementFactors none = factorDisplacement(nothing, grid, 2, StorageFormat::Float);
    EXPECT_EQ(measureFactors(nothing, grid, none).greatest, 0.0);
}

// Eckart and Young: no sum of so many products is nearer in squares than the rest of the spectrum.
TEST(DisplacementFactors, AreTheBestInSquares) {
    const ViewGrid grid = smallGrid();
    const DepthMap map = noiseMap(16, 10, WrapMode::Repeat, 7, 5);
    Table table = buildViewDisplacement(map, grid);
    constexpr int kTerms = 3;
    const DisplacementFactors factors =
        factorDisplacement(table, grid, kTerms, StorageFormat::Float);
    const std::size_t texels = map.depth.texels.size();
    Eigen::MatrixXd filled(texels * 6, table.size() / 6);  // azimuths
    double squares = 0.0;
    for (std::size_t view = 0; view < table.size(); ++view)
        for (std::size_t texel = 0; texel < texels; ++texel) {
            const double truth = table[view].texels[texel];
            filled(static_cast<Eigen::Index>(texel * 6 + view % 6),
                   static_cast<Eigen::Index>(view / 6)) = truth;
            const double error = displacementOf(factors, grid, view, texel) - truth;
            squares += error * error;
        }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(filled.transpose() * filled,
                                                                  Eigen::EigenvaluesOnly);
    const double rest = spectrum.eigenvalues().head(spectrum.eigenvalues().size() - kTerms).sum();
    EXPECT_GE(squares, rest * (1.0 - 1e-6));
    EXPECT_LE(squares, rest * (1.0 + 1e-6));
    EXPECT_LT(squares, 0.1 * (squares + filled.squaredNorm())) << "terms carry most of it";
    for (const Plane& factor : factors.factors)
        for (const float value : factor.texels)
            EXPECT_LE(std::abs(value), 1.0f);
}

TEST(DisplacementFactors, AreTheSameForOneAndTwoThreads) {
    const ViewGrid grid = smallGrid();
    const Table built = buildViewDisplacement(noiseMap(40, 30, WrapMode::Repeat, 2), grid);
    const auto build = [&] {
        Table table = built;
        const DisplacementFactors factors =
            factorDisplacement(table, grid, 5, StorageFormat::Float);
        return std::pair(factors, measureFactors(table, grid, factors));
    };
    const auto [one, oneError] = onThreads(1, build);
    const auto [two, twoError] = onThreads(2, build);
    EXPECT_EQ(one.weights, two.weights);
    for (std::size_t k = 0; k < one.factors.size(); ++k)
        EXPECT_EQ(one.factors[k].texels, two.factors[k].texels);
    EXPECT_EQ(oneError.mean, twoError.mean);
    EXPECT_EQ(oneError.percentile99, twoError.percentile99);
}

}  // namespace
}  // namespace relievo::preprocess
