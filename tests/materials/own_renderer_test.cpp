// The example of materials/examples, run as a renderer's author would run it.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/commands/process.h"
#include "textures/map_file.h"
#include "textures/picture_file.h"

namespace relievo::materials {
namespace {

// A disc that stands out of a plane, with the derivatives that its rim has.
textures::MapSet discMaps(bool withCones) {
    constexpr int kSize = 64;
    textures::Plane depth(kSize, kSize);
    for (int j = 0; j < kSize; ++j)
        for (int i = 0; i < kSize; ++i)
            depth.at(i, j) = static_cast<float>(
                std::clamp((std::hypot(i - 31.5, j - 31.5) - 16.0) / 4.0, 0.0, 1.0));
    textures::Plane dx(kSize, kSize);
    textures::Plane dy(kSize, kSize);
    for (int j = 1; j + 1 < kSize; ++j)
        for (int i = 1; i + 1 < kSize; ++i) {
            dx.at(i, j) = (depth.at(i + 1, j) - depth.at(i - 1, j)) * kSize / 2;
            dy.at(i, j) = (depth.at(i, j + 1) - depth.at(i, j - 1)) * kSize / 2;
        }
    textures::MapSet maps;
    maps.channels = {{"depth", depth}, {"dx", dx}, {"dy", dy}};
    if (withCones)
        maps.channels.push_back({"cone", textures::Plane(kSize, kSize, 1.0f / kSize)});
    return maps;
}

class OwnRenderer : public testing::Test {
  protected:
    tests::ProcessResult run(const textures::MapSet& maps, const std::string& technique) {
        textures::writeMapFile(folder_.file("disc.exr"), maps, textures::StorageFormat::Float);
        return tests::runProcess({RELIEVO_OWN_RENDERER, folder_.file("disc.exr"),
                                  folder_.file(technique + ".png"), technique});
    }

    float red(const std::string& technique, int x, int y) {
        return textures::readPicture(folder_.file(technique + ".png"))[0].at(x, y);
    }

    tests::ScratchFolder folder_;
};

TEST_F(OwnRenderer, ShowsTheReliefWithEveryTechniqueThatItIsGiven) {
    for (const std::string technique : {"normal", "linear", "relief", "cone"}) {
        const tests::ProcessResult result = run(discMaps(true), technique);
        ASSERT_EQ(result.exitStatus, 0) << result.errors;
        // Top of the disc and ground: the ground is darker, as the example's tone says, where the
        // technique really searches.
        const float top = red(technique, 256, 256);
        const float ground = red(technique, 460, 40);
        EXPECT_GT(top, 0.3f) << technique;
        if (technique == "normal")
            EXPECT_NEAR(ground, top, 0.02f);
        else
            EXPECT_LT(ground, 0.75f * top) << technique;
    }
}

TEST_F(OwnRenderer, SaysWhichChannelIsMissing) {
    const tests::ProcessResult result = run(discMaps(false), "cone");
    EXPECT_EQ(result.exitStatus, 1);
    EXPECT_THAT(result.errors, testing::HasSubstr("\"cone\""));
}

}  // namespace
}  // namespace relievo::materials
