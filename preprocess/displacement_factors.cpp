#include "preprocess/displacement_factors.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <utility>

#include "preprocess/view_displacement.h"

namespace relievo::preprocess {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using textures::Plane;
using Table = std::vector<Plane>;
using Advance = std::function<void(std::size_t)>;

// Views that differ in the azimuth alone are one column of the table.
std::size_t columnsOf(const ViewGrid& grid) {
    return grid.views() / static_cast<std::size_t>(grid.azimuths);
}

Eigen::Map<const Eigen::VectorXf> texelsOf(const Plane& plane) {
    return {plane.texels.data(), static_cast<Index>(plane.texels.size())};
}

// The products of the table's columns with each other. Sums are in one order, whatever the threads
// do.
MatrixXd productsOfColumns(const Table& table, const ViewGrid& grid, const Advance& advance) {
    const auto azimuths = static_cast<std::size_t>(grid.azimuths);
    const std::size_t columns = columnsOf(grid);
    MatrixXd products = MatrixXd::Zero(static_cast<Index>(columns), static_cast<Index>(columns));
    tbb::parallel_for(std::size_t{0}, columns, [&](std::size_t a) {
        for (std::size_t b = 0; b <= a; ++b)
            for (std::size_t azimuth = 0; azimuth < azimuths; ++azimuth)
                products(static_cast<Index>(a), static_cast<Index>(b)) +=
                    texelsOf(table[a * azimuths + azimuth])
                        .cast<double>()
                        .dot(texelsOf(table[b * azimuths + azimuth]).cast<double>());
        advance(a + 1);
    });
    return products;  // its lower half is all that the solver reads
}

// The best directions in the space of columns, orthonormal, the best first.
MatrixXd bestDirections(const Table& table, const ViewGrid& grid, Index count,
                        const Advance& advance) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(productsOfColumns(table, grid, advance));
    const MatrixXd& ascending = solver.eigenvectors();
    return ascending.rightCols(std::min(count, ascending.cols())).rowwise().reverse();
}

// A row of texels of the factor of one direction and azimuth.
Eigen::VectorXd projectRow(const Table& table, const ViewGrid& grid,
                           const Eigen::Ref<const Eigen::VectorXd>& direction, std::size_t azimuth,
                           int row) {
    const Index width = table.front().width;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(width);
    for (Index column = 0; column < direction.size(); ++column) {
        const std::size_t view =
            static_cast<std::size_t>(column) * static_cast<std::size_t>(grid.azimuths) + azimuth;
        sum += direction(column) * texelsOf(table[view]).segment(row * width, width).cast<double>();
    }
    return sum;
}

// The factor of one direction, a plane for each azimuth.
std::vector<Plane> project(const Table& table, const ViewGrid& grid,
                           const Eigen::Ref<const Eigen::VectorXd>& direction) {
    const int width = table.front().width;
    const int height = table.front().height;
    std::vector<Plane> factor(static_cast<std::size_t>(grid.azimuths), Plane(width, height));
    tbb::parallel_for(0, height, [&](int row) {
        for (std::size_t azimuth = 0; azimuth < factor.size(); ++azimuth)
            Eigen::Map<Eigen::VectorXf>(&factor[azimuth].at(0, row), width) =
                projectRow(table, grid, direction, azimuth, row).cast<float>();
    });
    return factor;
}

// The greatest value without its sign.
float spanOf(const std::vector<Plane>& factor) {
    float span = 0.0f;
    for (const Plane& plane : factor)
        span = std::max(span, texelsOf(plane).cwiseAbs().maxCoeff());
    return span;
}

// Adds the term of one direction.
void addTerm(const Table& table, const ViewGrid& grid,
             const Eigen::Ref<const Eigen::VectorXd>& direction, textures::StorageFormat format,
             DisplacementFactors& factors) {
    std::vector<Plane> factor = project(table, grid, direction);
    const float span = spanOf(factor);
    for (Plane& plane : factor) {
        if (span > 0.0f)
            for (float& value : plane.texels)
                value /= span;
        textures::storeInPlace(plane, "vdmfactor", format);
        factors.factors.push_back(std::move(plane));
    }
    std::vector<float>& weights = factors.weights.emplace_back();
    for (const double value : direction)
        weights.push_back(static_cast<float>(value * static_cast<double>(span)));
}

// Takes what has no hit out of the table.
std::vector<Plane> separateMisses(Table& table, const ViewGrid& grid) {
    std::vector<Plane> misses(missesPlanes(grid), Plane(table.front().width, table.front().height));
    tbb::parallel_for(std::size_t{0}, misses.size(), [&](std::size_t plane) {
        const auto azimuths = static_cast<std::size_t>(grid.azimuths);
        const int azimuth = static_cast<int>(plane % azimuths);
        const int curvature = grid.curvatures / 2 + 1 + static_cast<int>(plane / azimuths);
        for (int elevation = grid.elevations - 2; elevation >= 0; --elevation) {
            const Plane& steeper = table[grid.view(azimuth, elevation + 1, curvature)];
            Plane& distances = table[grid.view(azimuth, elevation, curvature)];
            for (std::size_t texel = 0; texel < steeper.texels.size(); ++texel)
                if (distances.texels[texel] == kNoHit) {
                    distances.texels[texel] = steeper.texels[texel];
                    misses[plane].texels[texel] += 1.0f;
                }
        }
    });
    return misses;
}

}  // namespace

std::size_t missesPlanes(const ViewGrid& grid) {
    return static_cast<std::size_t>(grid.azimuths) * static_cast<std::size_t>(grid.curvatures / 2);
}

std::size_t missesPlane(const ViewGrid& grid, int azimuth, int curvature) {
    assert(curvature > grid.curvatures / 2 && curvature < grid.curvatures);
    return static_cast<std::size_t>((curvature - grid.curvatures / 2 - 1) * grid.azimuths +
                                    azimuth);
}

std::size_t factorSteps(const ViewGrid& grid, int terms) {
    const std::size_t columns = columnsOf(grid);
    return columns * (columns + 1) / 2 +
           columns * std::min(columns, static_cast<std::size_t>(terms));
}

DisplacementFactors factorDisplacement(std::vector<Plane>& table, const ViewGrid& grid, int terms,
                                       textures::StorageFormat format, const Advance& advance) {
    assert(terms >= 1 && table.size() == grid.views());
    const Advance tell = advance ? advance : [](std::size_t) {};
    DisplacementFactors result;
    result.misses = separateMisses(table, grid);
    const MatrixXd directions = bestDirections(table, grid, terms, tell);
    for (Index k = 0; k < directions.cols(); ++k) {
        addTerm(table, grid, directions.col(k), format, result);
        tell(columnsOf(grid));
    }
    const std::size_t planes =
        static_cast<std::size_t>(terms) * static_cast<std::size_t>(grid.azimuths);
    result.factors.resize(planes, Plane(table.front().width, table.front().height));
    result.weights.resize(static_cast<std::size_t>(terms), std::vector<float>(columnsOf(grid)));
    return result;
}

double displacementOf(const DisplacementFactors& factors, const ViewGrid& grid, std::size_t view,
                      std::size_t texel) {
    const auto azimuths = static_cast<std::size_t>(grid.azimuths);
    double sum = 0.0;
    for (std::size_t k = 0; k < factors.weights.size(); ++k)
        sum += static_cast<double>(factors.factors[k * azimuths + view % azimuths].texels[texel]) *
               static_cast<double>(factors.weights[k][view / azimuths]);
    return sum;
}

}  // namespace relievo::preprocess
