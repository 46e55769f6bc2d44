#include "textures/cone_layers.h"

#include <gmock/gmock.h>

#include <string>

#include "textures/input_error.h"

namespace relievo::textures {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

MapSet mapsWith(const std::vector<std::string>& names) {
    MapSet maps;
    for (const std::string& name : names)
        maps.channels.push_back({name, Plane(2, 2)});
    return maps;
}

TEST(ConeLayers, OneSectorHasNoNumber) {
    const MapSet maps = mapsWith({"depth", "cone"});
    EXPECT_THAT(coneLayersOf(maps), ElementsAre(maps.find("cone")));
}

TEST(ConeLayers, SectorsAreInTheOrderOfTheirNumbers) {
    const MapSet maps = mapsWith({"cone3", "cone1", "depth", "cone0", "cone2"});
    EXPECT_THAT(coneLayersOf(maps), ElementsAre(maps.find("cone0"), maps.find("cone1"),
                                                maps.find("cone2"), maps.find("cone3")));
}

TEST(ConeLayers, NoneIsNoError) {
    EXPECT_TRUE(coneLayersOf(mapsWith({"depth", "roof", "ratio"})).empty());
}

TEST(ConeLayers, AnotherNumberOfSectorsIsRefused) {
    for (const std::vector<std::string>& names :
         {std::vector<std::string>{"cone0"}, {"cone0", "cone1", "cone2"}}) {
        const MapSet maps = mapsWith(names);
        EXPECT_THAT([&] { coneLayersOf(maps); },
                    ThrowsMessage<InputError>(
                        HasSubstr("for " + std::to_string(names.size()) + " sectors")));
    }
}

}  // namespace
}  // namespace relievo::textures
