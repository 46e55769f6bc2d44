#include "reference/error_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace relievo::reference {
namespace {

HitComparison offBy(double error) {
    HitComparison ray;
    ray.found = ray.exists = true;
    ray.exactDistance = 2.0;
    ray.distance = 2.0 + error;
    return ray;
}

TEST(ErrorMetrics, NothingGivesZeros) {
    const ErrorStatistics result = summarizeErrors({}, 0.1);
    EXPECT_EQ(result.rays, 0u);
    EXPECT_EQ(result.wrongShare, 0.0);
    EXPECT_EQ(result.maximumDistance, 0.0);
}

TEST(ErrorMetrics, EveryKindOfWrong) {
    std::vector<HitComparison> rays(10, offBy(0.0));
    rays[0] = offBy(0.5);                    // too far
    rays[1] = offBy(-0.5);                   // too near
    rays[2].exists = false;                  // a hit where there is none
    rays[3].found = false;                   // a miss where there is a hit
    rays[4].converged = false;               // right by chance
    rays[5].found = rays[5].exists = false;  // rightly nothing
    rays[6].distance = std::numeric_limits<double>::quiet_NaN();
    rays[7] = offBy(0.25);  // within the tolerance
    const ErrorStatistics result = summarizeErrors(rays, 0.25);
    EXPECT_EQ(result.rays, 10u);
    EXPECT_EQ(result.compared, 6u);
    EXPECT_DOUBLE_EQ(result.wrongShare, 0.6);
    EXPECT_DOUBLE_EQ(result.unconvergedShare, 0.1);
    EXPECT_DOUBLE_EQ(result.overshotShare, 0.1);
    EXPECT_DOUBLE_EQ(result.meanDistance, 1.25 / 6.0);
    EXPECT_DOUBLE_EQ(result.maximumDistance, 0.5);
}

TEST(ErrorMetrics, PercentileIsByNearestRank) {
    std::vector<HitComparison> rays;
    for (int k = 200; k >= 1; --k)
        rays.push_back(offBy(k % 2 == 0 ? k : -k));
    // 198 of 200 are 99 %.
    EXPECT_DOUBLE_EQ(summarizeErrors(rays, 0.0).percentile99Distance, 198.0);
    // Of 201, 198 are fewer than 99 %; 199 are enough.
    rays.push_back(offBy(0.0));
    EXPECT_DOUBLE_EQ(summarizeErrors(rays, 0.0).percentile99Distance, 198.0);
    rays.resize(3);
    EXPECT_DOUBLE_EQ(summarizeErrors(rays, 0.0).percentile99Distance, 200.0);
    rays.resize(1);
    EXPECT_DOUBLE_EQ(summarizeErrors(rays, 0.0).percentile99Distance, 200.0);
}

TEST(ErrorMetrics, NormalAngles) {
    std::vector<HitComparison> rays(2, offBy(0.0));
    const double small = 1e-9;
    rays[0].normal = {std::sin(small), 0.0, std::cos(small)};
    rays[1].normal = {0.0, 1.0, 0.0};
    const ErrorStatistics result = summarizeErrors(rays, 0.0);
    EXPECT_NEAR(result.meanNormalAngle, 45.0 + small * 90.0 / std::acos(-1.0), 1e-12);
    EXPECT_DOUBLE_EQ(result.percentile99NormalAngle, 90.0);
    rays.resize(1);
    EXPECT_NEAR(summarizeErrors(rays, 0.0).meanNormalAngle, small * 180.0 / std::acos(-1.0), 1e-18);
}

TEST(ErrorMetrics, ANormalThatIsNotANumberIsWrong) {
    std::vector<HitComparison> rays(1, offBy(0.0));
    rays[0].normal.x = std::numeric_limits<double>::quiet_NaN();
    const ErrorStatistics result = summarizeErrors(rays, 1.0);
    EXPECT_EQ(result.wrongShare, 1.0);
    EXPECT_EQ(result.compared, 0u);
}

}  // namespace
}  // namespace relievo::reference
