#include "preprocess/relief_baker.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <stdexcept>

#include "preprocess/cone_kinds.h"
#include "preprocess/map_kinds.h"

namespace relievo::preprocess {
namespace {

using testing::HasSubstr;
using textures::DepthMap;
using textures::MapSet;
using textures::Plane;
using textures::StorageFormat;

DepthMap hills(int width, int height) {
    DepthMap map{Plane(width, height), textures::WrapMode::Mirror};
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            map.depth.at(i, j) =
                static_cast<float>(0.5 + 0.3 * std::sin(0.7 * i) * std::cos(0.4 * j));
    return map;
}

std::set<std::string> namesOf(const MapSet& maps) {
    std::set<std::string> names;
    for (const textures::Channel& channel : maps.channels)
        names.insert(channel.name);
    return names;
}

// Every entry of both tables keeps what it says: these channels, and all texels told of.
TEST(ReliefBaker, EveryKindGivesTheChannelsThatItNames) {
    for (const ConeKind& cone : coneKinds()) {
        ReliefPlan plan;
        plan.maps.clear();
        for (const MapKind& kind : mapKinds())
            plan.maps.emplace_back(kind.name);
        plan.cone = cone.cone;
        plan.guarantee = cone.guarantee;
        plan.method = cone.method;
        SCOPED_TRACE(plan.cone + " " + plan.guarantee + " " + plan.method);
        ASSERT_EQ(planProblem(plan), "");
        std::set<std::string> expected;
        for (const MapKind& kind : mapKinds())
            for (const std::string& channel : kind.channels(plan))
                EXPECT_TRUE(expected.insert(channel).second) << channel;
        std::atomic<std::size_t> texels{0};
        std::vector<std::string> begun;
        BakeObserver observer;
        observer.begin = [&](std::string_view map, std::size_t) {
            begun.emplace_back(map);
            texels = 0;
        };
        observer.advance = [&](std::size_t done) { texels += done; };
        observer.end = [&](std::string_view map, const std::string&) {
            EXPECT_TRUE(texels == 23u * 9u || (texels == 0u && map != "cone")) << map;
        };
        const MapSet maps = bakeRelief(hills(23, 9), plan, observer);
        EXPECT_EQ(namesOf(maps), expected);
        EXPECT_EQ(begun.size() + 1, mapKinds().size()) << "all but depth are built";
        EXPECT_EQ(maps.attributes.at("relievo:cone"), cone.cone);
        EXPECT_EQ(maps.attributes.at("relievo:guarantee"), cone.guarantee);
        EXPECT_EQ(maps.attributes.at("relievo:method"), cone.method);
    }
}

TEST(ReliefBaker, MapsNotAskedForAreNotThere) {
    ReliefPlan plan;
    plan.maps = {"derivative"};
    const MapSet maps = bakeRelief(hills(5, 4), plan);
    EXPECT_EQ(namesOf(maps), (std::set<std::string>{"dx", "dy"}));
    EXPECT_EQ(maps.wrap, textures::WrapMode::Mirror);
    EXPECT_EQ(maps.attributes.size(), 1u) << "the options";
}

TEST(ReliefBaker, MapsBelongToTheDepthsAsStored) {
    ReliefPlan plan;
    plan.maps = {"depth"};
    plan.format = StorageFormat::U8;
    const DepthMap relief = hills(16, 16);
    EXPECT_EQ(bakeRelief(relief, plan).find("depth")->texels,
              textures::storedValues(relief.depth, "depth", StorageFormat::U8).texels);
}

TEST(ReliefBaker, LevelsAreReliefsOfTheirOwn) {
    ReliefPlan plan;
    plan.mips = true;
    plan.encoding = textures::ConeEncoding::Ratio;
    const std::vector<MapSet> levels = bakeLevels(hills(21, 10), plan);
    ASSERT_EQ(levels.size(), 5u);
    plan.mips = false;
    for (const MapSet& level : levels) {
        const MapSet alone = bakeRelief(textures::depthMapOf(level), plan);
        EXPECT_EQ(namesOf(level), namesOf(alone));
        for (const textures::Channel& channel : alone.channels)
            EXPECT_EQ(level.find(channel.name)->texels, channel.plane.texels) << channel.name;
    }
    EXPECT_EQ(bakeLevels(hills(21, 10), plan).size(), 1u);
}

TEST(ReliefBaker, OptionWordsTellPlansApart) {
    const ReliefPlan usual;
    ReliefPlan same = usual;
    std::swap(same.maps.front(), same.maps.back());
    same.method = "exact";
    same.normalScale = 0.7;
    EXPECT_EQ(optionWords(same), optionWords(usual)) << "no normals, and the default method";
    std::set<std::string> words{optionWords(usual)};
    const auto expectNew = [&](auto change) {
        ReliefPlan plan;
        change(plan);
        EXPECT_TRUE(words.insert(optionWords(plan)).second) << optionWords(plan);
    };
    expectNew([](ReliefPlan& plan) { plan.mips = true; });
    expectNew([](ReliefPlan& plan) { plan.cone = "roof"; });
    expectNew([](ReliefPlan& plan) {
        plan.cone = "roof";
        plan.sectors = 8;
    });
    expectNew([](ReliefPlan& plan) { plan.cone = "relaxed"; });
    expectNew([](ReliefPlan& plan) {
        plan.cone = "relaxed";
        plan.sectors = 1;
    });
    expectNew([](ReliefPlan& plan) { plan.method = "levels"; });
    expectNew([](ReliefPlan& plan) { plan.format = StorageFormat::Half; });
    expectNew([](ReliefPlan& plan) {
        plan.guarantee = "texel";
        plan.encoding = textures::ConeEncoding::Radius;
    });
    expectNew([](ReliefPlan& plan) { plan.maps = {"depth"}; });
    expectNew([](ReliefPlan& plan) { plan.maps = {"depth", "normal"}; });
    expectNew([](ReliefPlan& plan) {
        plan.maps = {"depth", "normal"};
        plan.normalScale = 0.7;
    });
    for (const std::string map : {"occlusion", "ellipse", "horizon", "volume", "extrema", "vdm"})
        expectNew([&](ReliefPlan& plan) { plan.maps = {map}; });
    for (const std::string map : {"occlusion", "ellipse", "horizon"})
        expectNew([&](ReliefPlan& plan) {
            plan.maps = {map};
            plan.azimuths = 16;
        });
    expectNew([](ReliefPlan& plan) {
        plan.maps = {"volume"};
        plan.slices = 3;
    });
    expectNew([](ReliefPlan& plan) {
        plan.maps = {"volume"};
        plan.volumeScale = 0.3;
    });
    expectNew([](ReliefPlan& plan) {
        plan.maps = {"extrema"};
        plan.reach = 1;
    });
    expectNew([](ReliefPlan& plan) { plan.maps = {"cylinder"}; });
    expectNew([](ReliefPlan& plan) {
        plan.maps = {"cylinder"};
        plan.cylinderTolerance = 0.0;
    });
    const auto expectNewViews = [&](auto change) {
        expectNew([&](ReliefPlan& plan) {
            plan.maps = {"vdm"};
            change(plan);
        });
    };
    expectNewViews([](ReliefPlan& plan) { plan.views.azimuths = 7; });
    expectNewViews([](ReliefPlan& plan) { plan.views.elevations = 7; });
    expectNewViews([](ReliefPlan& plan) { plan.views.curvatures = 7; });
    expectNewViews([](ReliefPlan& plan) { plan.views.sharpest = 7; });
    expectNewViews([](ReliefPlan& plan) { plan.views.depthScale = 7; });
    expectNewViews([](ReliefPlan& plan) { plan.terms = 7; });
}

TEST(ReliefBaker, DisplacementsAreFactorsOrTheTable) {
    ReliefPlan plan;
    plan.maps = {"vdm"};
    plan.views.azimuths = 5;
    plan.views.elevations = 2;
    plan.terms = 3;
    const MapSet packed = bakeRelief(hills(6, 4), plan);
    EXPECT_EQ(packed.channels.size(), 3u * 5u + 5u * 2u);
    EXPECT_EQ(packed.attributes.at("relievo:vdm-views"), "5 2 5");
    const std::string& weights = packed.attributes.at("relievo:vdm-weights");
    EXPECT_EQ(std::count(weights.begin(), weights.end(), ' ') + 1, 3 * 2 * 5);
    plan.terms = 0;
    plan.mips = true;
    for (const MapSet& level : bakeLevels(hills(6, 4), plan)) {
        EXPECT_EQ(level.channels.size(), plan.views.views());
        EXPECT_FALSE(level.attributes.contains("relievo:vdm-weights"));
    }
}

TEST(ReliefBaker, OcclusionIsTheSameWithAndWithoutTheHorizonsInTheFile) {
    ReliefPlan plan;
    plan.maps = {"occlusion", "ellipse"};
    const MapSet alone = bakeRelief(hills(20, 14), plan);
    plan.maps.emplace_back("horizon");
    const MapSet beside = bakeRelief(hills(20, 14), plan);
    for (const textures::Channel& channel : alone.channels)
        EXPECT_EQ(beside.find(channel.name)->texels, channel.plane.texels) << channel.name;
}

TEST(ReliefBaker, ImpossiblePlansAreTold) {
    const auto problem = [](auto change) {
        ReliefPlan plan;
        change(plan);
        const std::string sentence = planProblem(plan);
        EXPECT_THROW(bakeRelief(hills(4, 4), plan), std::invalid_argument) << sentence;
        return sentence;
    };
    EXPECT_EQ(planProblem(ReliefPlan{}), "");
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.slices = 0; }), HasSubstr("--slices"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.volumeScale = 0.0; }),
                HasSubstr("--volume-scale"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.azimuths = 2; }), HasSubstr("--azimuths"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.reach = -1; }), HasSubstr("--reach"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.cylinderTolerance = 2.0; }),
                HasSubstr("--cylinder-tolerance"));
    EXPECT_THAT(problem([](ReliefPlan& plan) {
                    plan.maps = {"depth", "moon"};
                }),
                HasSubstr("--maps: 'moon' is no map, expected some of cone, "));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.maps.clear(); }), HasSubstr("--maps: "));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.method = "magic"; }),
                HasSubstr("--cone conservative --method magic: not available, expected --method "));
    EXPECT_THAT(problem([](ReliefPlan& plan) {
                    plan.maps = {"cone"};
                    plan.guarantee = "texel";
                    plan.encoding = textures::ConeEncoding::Radius;
                }),
                HasSubstr("need the map"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.encoding = textures::ConeEncoding::Radius; }),
                HasSubstr("nothing over depth 0"));
    EXPECT_THAT(problem([](ReliefPlan& plan) {
                    plan.maps.emplace_back("normal");
                    plan.format = StorageFormat::U16;
                }),
                HasSubstr("7 channels"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.views.azimuths = 2; }),
                HasSubstr("--vdm-azimuths"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.views.elevations = 0; }),
                HasSubstr("--vdm-elevations"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.views.curvatures = 4; }),
                HasSubstr("--vdm-curvatures: expected an odd number"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.views.sharpest = -1.0; }),
                HasSubstr("--vdm-range"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.views.depthScale = 0.0; }),
                HasSubstr("--vdm-scale"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.terms = -1; }), HasSubstr("--vdm-terms"));
    EXPECT_THAT(problem([](ReliefPlan& plan) {
                    plan.views.azimuths = kMostAzimuths;
                    plan.views.elevations = kMostElevations;
                }),
                HasSubstr("81920 views, expected at most 16384"));
    EXPECT_THAT(problem([](ReliefPlan& plan) {
                    plan.maps = {"vdm"};
                    plan.mips = true;
                }),
                HasSubstr("--mips: the map vdm"));
    EXPECT_THAT(problem([](ReliefPlan& plan) {
                    plan.maps = {"vdm"};
                    plan.format = StorageFormat::U16;
                }),
                HasSubstr(".exr files only"));
    EXPECT_THAT(problem([](ReliefPlan& plan) { plan.normalScale = std::nan(""); }),
                HasSubstr("--normal-scale"));
}

}  // namespace
}  // namespace relievo::preprocess
