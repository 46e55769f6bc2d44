#include "textures/bundled_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "textures/picture_file.h"
#include "textures/sample_albedo.h"
#include "textures/sample_reliefs.h"

namespace relievo::textures {
namespace {

std::filesystem::path sampleFile(const BundledSample& sample, const char* part) {
    return std::filesystem::path(RELIEVO_SAMPLES_FOLDER) /
           (std::string(sample.name) + "-" + part + ".png");
}

TEST(BundledSamples, HeightsAreThoseOfTheGenerator) {
    for (const BundledSample& sample : kBundledSamples) {
        SCOPED_TRACE(sample.name);
        const std::vector<Plane> read = readPicture(sampleFile(sample, "height"));
        const Plane depth = generateSampleRelief(sample.name, sample.size, sample.size).depth;
        ASSERT_EQ(read.size(), 1u);
        ASSERT_EQ(read[0].width, sample.size);
        ASSERT_EQ(read[0].height, sample.size);
        for (std::size_t t = 0; t < depth.texels.size(); ++t)
            ASSERT_EQ(
                read[0].texels[t],
                static_cast<float>(std::nearbyint((1.0f - depth.texels[t]) * 65535.0) / 65535.0))
                << "run relievo-samples textures/samples after a change of the generators";
    }
}

TEST(BundledSamples, AlbedosAreThoseOfTheGenerator) {
    for (const BundledSample& sample : kBundledSamples) {
        const std::vector<Plane> read = readPicture(sampleFile(sample, "albedo"));
        const auto albedo = generateSampleAlbedo(sample.name, sample.size, sample.size);
        ASSERT_EQ(read.size(), 3u);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t t = 0; t < albedo[c].texels.size(); ++t)
                ASSERT_NEAR(read[c].texels[t], albedo[c].texels[t], 0.501 / 255.0) << sample.name;
    }
}

TEST(BundledSamples, FilesAreSmall) {
    for (const BundledSample& sample : kBundledSamples)
        for (const char* part : {"height", "albedo"})
            EXPECT_LT(std::filesystem::file_size(sampleFile(sample, part)), 300'000u);
}

}  // namespace
}  // namespace relievo::textures
