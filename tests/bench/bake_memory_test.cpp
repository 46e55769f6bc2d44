// The memory of builders, counted.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>

#include "bench/bake_benchmark.h"
#include "bench/bake_builders.h"

namespace relievo::bench {
namespace {

// Bytes besides map and result for each texel that a map has more. Tables of a fixed size do not
// count; a large map has almost nothing else. On one thread: every further one has such tables, and
// it is chance whether it comes in time to make them for a small map.
std::map<std::string, double> bytesPerFurtherTexel(const std::vector<std::string>& builders) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    BakeBenchmarkOptions options;
    options.samples = {"cobbles"};
    options.builders = builders;
    options.sizes = {192, 384};
    options.repeat = 1;
    std::map<std::string, double> bytes;
    for (const BakeMeasurement& m : measureBake(options)) {
        const double texels = static_cast<double>(m.size) * m.size;
        const double further = 384.0 * 384.0 - 192.0 * 192.0;
        bytes[m.builder] +=
            (m.size == 384 ? 1.0 : -1.0) * m.workingBytes.value() * texels / further;
    }
    return bytes;
}

TEST(BakeMemory, OfConesIsUnder40BytesATexelAndWhatRelievoBakeCountsOn) {
    for (const auto& [builder, bytes] :
         bytesPerFurtherTexel({"cones-bilinear", "cones-texel", "cones-quick", "roof-1", "roof-4",
                               "relaxed-bilinear", "relaxed-texel", "relaxed-maxima"})) {
        EXPECT_LT(bytes, 40.0) << builder;
        EXPECT_GT(bytes, 1.0) << builder << ": all of them have a pyramid or a copy at least";
        EXPECT_LE(bytes, bakeBuilder(builder).statedBytes.value()) << builder;
    }
}

// Some rows at a time come on top, as in the file formats.
TEST(BakeMemory, OfOtherMapsIsWhatRelievoBakeCountsOn) {
    for (const auto& [builder, bytes] :
         bytesPerFurtherTexel({"volume", "horizon", "ellipse", "occlusion", "cylinder"}))
        EXPECT_LE(bytes, bakeBuilder(builder).statedBytes.value()) << builder;
}

}  // namespace
}  // namespace relievo::bench
