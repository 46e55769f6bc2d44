#include "textures/displacement_table.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <string>

#include "textures/input_error.h"

namespace relievo::textures {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// 3 azimuths, 2 elevations, 3 curvatures, of which the plane is number 1.
MapSet mapsWith(const std::string& channel, std::size_t count) {
    MapSet maps;
    for (std::size_t k = 0; k < count; ++k)
        maps.channels.push_back({channel + std::to_string(k), Plane(2, 2)});
    maps.attributes["relievo:vdm-views"] = "3 2 3";
    maps.attributes["relievo:vdm-scale"] = "0.2";
    return maps;
}

MapSet packedMaps() {
    MapSet maps = mapsWith("vdmfactor", 6);
    maps.attributes["relievo:vdm-weights"] = "1 2 3 4 5 6 7 8 9 10 11 12";
    return maps;
}

TEST(DisplacementTable, APackedOneHasTheWeightsOfThePlane) {
    const MapSet maps = packedMaps();
    const DisplacementTable table = displacementTableOf(maps);
    EXPECT_EQ(table.azimuths, 3);
    ASSERT_EQ(table.terms(), 2u);
    ASSERT_EQ(table.factors.size(), 6u);
    EXPECT_EQ(table.factors[4], maps.find("vdmfactor4"));
    ASSERT_EQ(table.weights.size(), 2u);
    const double low = std::sin(std::numbers::pi / 4) / 0.2;
    EXPECT_FLOAT_EQ(table.weights[0][0], static_cast<float>(3 * low));
    EXPECT_FLOAT_EQ(table.weights[0][1], static_cast<float>(9 * low));
    EXPECT_FLOAT_EQ(table.weights[1][0], static_cast<float>(4 / 0.2));
}

TEST(DisplacementTable, AWholeOneHasATermForEachElevation) {
    const MapSet maps = mapsWith("vdm", 18);
    const DisplacementTable table = displacementTableOf(maps);
    ASSERT_EQ(table.terms(), 2u);
    ASSERT_EQ(table.factors.size(), 6u);
    // The plane's views begin at 6; the second elevation, azimuth 2, is the last of them.
    EXPECT_EQ(table.factors[5], maps.find("vdm11"));
    EXPECT_FLOAT_EQ(table.weights[0][0], static_cast<float>(std::sin(std::numbers::pi / 4) / 0.2));
    EXPECT_EQ(table.weights[0][1], 0.0f);
    EXPECT_FLOAT_EQ(table.weights[1][1], 5.0f);
}

TEST(DisplacementTable, NoneIsNoError) {
    EXPECT_EQ(displacementTableOf(mapsWith("depth", 1)).terms(), 0u);
}

TEST(DisplacementTable, WhatIsWrongIsNamed) {
    const auto read = [](const MapSet& maps) { return [maps] { displacementTableOf(maps); }; };
    const auto with = [](const char* attribute, const char* value) {
        MapSet maps = packedMaps();
        maps.attributes[attribute] = value;
        return maps;
    };
    EXPECT_THAT(read(mapsWith("vdm", 11)),
                ThrowsMessage<InputError>(HasSubstr("lacks the channel 'vdm11'")));
    EXPECT_THAT(read(mapsWith("vdmfactor", 5)),
                ThrowsMessage<InputError>(HasSubstr("5 channels 'vdmfactor'")));
    EXPECT_THAT(read(mapsWith("vdmfactor", 6)),
                ThrowsMessage<InputError>(HasSubstr("lacks the attribute 'relievo:vdm-weights'")));
    for (const char* views : {"", "3 2", "3 2 3 1", "3 two 3", "0 2 3", "3 2.5 3", "inf 2 3"})
        EXPECT_THAT(read(with("relievo:vdm-views", views)),
                    ThrowsMessage<InputError>(HasSubstr("relievo:vdm-views")))
            << views;
    for (const char* scale : {"", "0", "-1", "nan", "0.1x"})
        EXPECT_THAT(read(with("relievo:vdm-scale", scale)),
                    ThrowsMessage<InputError>(HasSubstr("relievo:vdm-scale")))
            << scale;
    EXPECT_THAT(read(with("relievo:vdm-weights", "1 2 3")),
                ThrowsMessage<InputError>(HasSubstr("expected 12 numbers")));
}

}  // namespace
}  // namespace relievo::textures
