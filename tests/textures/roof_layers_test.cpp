#include "textures/roof_layers.h"

#include <gmock/gmock.h>

#include "textures/input_error.h"

namespace relievo::textures {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

MapSet mapsWith(const std::vector<std::string>& names) {
    MapSet maps;
    for (const std::string& name : names)
        maps.channels.push_back({name, Plane(2, 2)});
    return maps;
}

TEST(RoofLayers, OneLayerHasNoNumber) {
    const MapSet maps = mapsWith({"depth", "ratio", "roof"});
    const RoofLayers roofs = roofLayersOf(maps);
    ASSERT_EQ(roofs.layers.size(), 1u);
    EXPECT_EQ(roofs.layers[0].roof, maps.find("roof"));
    EXPECT_EQ(roofs.layers[0].ratio, maps.find("ratio"));
    EXPECT_EQ(roofs.block, 1);
}

TEST(RoofLayers, SectorsAreInTheOrderOfTheirNumbers) {
    MapSet maps =
        mapsWith({"roof3", "ratio3", "roof1", "ratio1", "roof0", "ratio0", "roof2", "ratio2"});
    maps.attributes["relievo:block"] = "2";
    const RoofLayers roofs = roofLayersOf(maps);
    ASSERT_EQ(roofs.layers.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_EQ(roofs.layers[k].roof, maps.find("roof" + std::to_string(k)));
    EXPECT_EQ(roofs.block, 2);
}

TEST(RoofLayers, NoneIsNoError) {
    EXPECT_TRUE(roofLayersOf(mapsWith({"depth", "cone"})).layers.empty());
}

TEST(RoofLayers, WhatIsMissingIsNamed) {
    const auto read = [](const MapSet& maps) { return [maps] { roofLayersOf(maps); }; };
    EXPECT_THAT(read(mapsWith({"roof"})),
                ThrowsMessage<InputError>(HasSubstr("lacks the channel 'ratio'")));
    EXPECT_THAT(read(mapsWith({"roof0", "ratio0", "ratio1"})),
                ThrowsMessage<InputError>(HasSubstr("lacks the channel 'roof1'")));
    EXPECT_THAT(read(mapsWith({"roof0", "ratio0", "roof1", "ratio1"})),
                ThrowsMessage<InputError>(HasSubstr("2 layers of roof cones")));
    for (const char* block : {"", "few", "0", "1.5"}) {
        MapSet maps = mapsWith({"roof", "ratio"});
        maps.attributes["relievo:block"] = block;
        EXPECT_THAT(read(maps), ThrowsMessage<InputError>(HasSubstr("relievo:block"))) << block;
    }
}

}  // namespace
}  // namespace relievo::textures
