#include "textures/map_file.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "random_planes.h"
#include "temporary_folder.h"
#include "textures/image_reader.h"
#include "textures/version.h"

namespace relievo::textures {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MapFile : public TemporaryFolder {};

struct FileKind {
    const char* name;
    StorageFormat format;
};

constexpr std::array kKinds{
    FileKind{"a.exr", StorageFormat::Float}, FileKind{"b.exr", StorageFormat::Half},
    FileKind{"c.png", StorageFormat::U16},   FileKind{"d.png", StorageFormat::U8},
    FileKind{"e.tif", StorageFormat::U16},   FileKind{"f.tiff", StorageFormat::U8},
};

MapSet randomMaps(int width, int height) {
    MapSet maps;
    maps.wrap = WrapMode::Mirror;
    maps.encoding = ConeEncoding::Radius;
    maps.source = "0123456789abcdef";
    maps.attributes = {{"relievo:cone", "conservative"}, {"relievo:method", "exact \"1\""}};
    maps.channels = {{"depth", randomPlane(width, height, 0.0f, 1.0f, 1)},
                     {"dx", randomPlane(width, height, -7.0f, 5.0f, 2)},
                     {"dy", randomPlane(width, height, -1.0f, 3.0f, 3)},
                     {"cone", randomPlane(width, height, 0.0f, 2.0f, 4)}};
    return maps;
}

std::vector<std::string> namesOf(const MapSet& maps) {
    std::vector<std::string> names;
    for (const Channel& channel : maps.channels)
        names.push_back(channel.name);
    return names;
}

TEST_F(MapFile, ReadsBackWhatWasStored) {
    for (const auto& [width, height] : {std::array{1, 1}, std::array{1, 9}, std::array{37, 11}})
        for (const FileKind& kind : kKinds) {
            SCOPED_TRACE(kind.name);
            const MapSet maps = randomMaps(width, height);
            writeMapFile(file(kind.name), maps, kind.format);
            const MapSet read = readMapFile(file(kind.name));
            EXPECT_EQ(read.kind, "relief");
            EXPECT_EQ(read.wrap, WrapMode::Mirror);
            EXPECT_EQ(read.encoding, ConeEncoding::Radius);
            EXPECT_EQ(read.source, maps.source);
            EXPECT_EQ(read.version, kVersion);
            EXPECT_EQ(read.attributes, maps.attributes);
            ASSERT_EQ(read.channels.size(), 4u);
            EXPECT_EQ(read.width(), width);
            EXPECT_EQ(read.height(), height);
            for (const Channel& channel : maps.channels) {
                ASSERT_NE(read.find(channel.name), nullptr);
                EXPECT_EQ(read.find(channel.name)->texels,
                          storedValues(channel.plane, channel.name, kind.format).texels)
                    << channel.name;
            }
        }
}

TEST_F(MapFile, WritingWhatWasReadGivesTheSameBytes) {
    for (const FileKind& kind : kKinds) {
        writeMapFile(file(kind.name), randomMaps(23, 17), kind.format);
        const std::string first = readBytes(file(kind.name));
        writeMapFile(file(kind.name), readMapFile(file(kind.name)), kind.format);
        EXPECT_EQ(readBytes(file(kind.name)), first) << kind.name;
    }
}

TEST_F(MapFile, RootsOfRatiosAreAMatterOfTheFileAlone) {
    MapSet maps = randomMaps(31, 8);
    maps.encoding = ConeEncoding::Sqrt;
    for (const FileKind& kind : kKinds) {
        SCOPED_TRACE(kind.name);
        writeMapFile(file(kind.name), maps, kind.format);
        const MapSet read = readMapFile(file(kind.name));
        EXPECT_EQ(read.encoding, ConeEncoding::Sqrt);
        const Plane& ratio = maps.channels[3].plane;
        EXPECT_EQ(read.find("cone")->texels,
                  storedValues(ratio, "cone", kind.format, ConeEncoding::Sqrt).texels);
        for (std::size_t t = 0; t < ratio.texels.size(); ++t)
            EXPECT_LE(read.find("cone")->texels[t], ratio.texels[t]);
    }
}

// Several blocks of rows, the last one not whole.
TEST_F(MapFile, TallFilesComeBackWhole) {
    const MapSet maps = randomMaps(3, 700);
    for (const FileKind& kind : kKinds) {
        writeMapFile(file(kind.name), maps, kind.format);
        EXPECT_EQ(readMapFile(file(kind.name)).find("dy")->texels,
                  storedValues(maps.channels[2].plane, "dy", kind.format).texels)
            << kind.name;
    }
}

std::vector<MapSet> randomLevels(int width, int height) {
    std::vector<MapSet> levels{randomMaps(width, height)};
    while (width > 1 || height > 1) {
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
        levels.push_back(randomMaps(width, height));
    }
    return levels;
}

TEST_F(MapFile, LevelsComeBackWithTheirShapes) {
    for (const FileKind& kind : kKinds) {
        SCOPED_TRACE(kind.name);
        const bool isPng = std::string_view(kind.name).ends_with(".png");
        for (const auto& [width, height] : {std::array{150, 71}, std::array{1, 5}}) {
            const std::vector<MapSet> levels = randomLevels(width, height);
            if (isPng) {
                EXPECT_THAT(errorOf([&] { writeMapFile(file(kind.name), levels, kind.format); }),
                            HasSubstr("expected .exr or .tif"));
                continue;
            }
            writeMapFile(file(kind.name), levels, kind.format);
            const std::vector<MapSet> read = readMapLevels(file(kind.name));
            ASSERT_EQ(read.size(), levels.size());
            EXPECT_EQ(readMapFile(file(kind.name)).find("dx")->texels, read[0].find("dx")->texels);
            EXPECT_EQ(readMapDescription(file(kind.name)).source, levels[0].source);
            for (std::size_t k = 0; k < levels.size(); ++k) {
                EXPECT_EQ(read[k].width(), levels[k].width());
                EXPECT_NEAR(depthMapOf(read[k]).aspect(), static_cast<double>(height) / width,
                            1e-12);
                EXPECT_EQ(read[k].attributes, levels[0].attributes);
                for (std::size_t t = 0; t < levels[k].channels[3].plane.texels.size(); ++t) {
                    EXPECT_LE(read[k].find("cone")->texels[t],
                              levels[k].channels[3].plane.texels[t]);
                    EXPECT_NEAR(read[k].find("depth")->texels[t],
                                levels[k].channels[0].plane.texels[t], 0.5 / 255 + 1e-6);
                }
            }
        }
    }
}

TEST_F(MapFile, LevelsThatAreNoneAreRefused) {
    std::vector<MapSet> levels = randomLevels(9, 4);
    levels.pop_back();
    EXPECT_THROW(writeMapFile(file("a.exr"), levels, StorageFormat::Float), std::invalid_argument);
    levels = randomLevels(9, 4);
    levels.erase(levels.begin() + 1);
    EXPECT_THROW(writeMapFile(file("a.exr"), levels, StorageFormat::Float), std::invalid_argument);
    levels = randomLevels(9, 4);
    levels[2].channels.pop_back();
    EXPECT_THROW(writeMapFile(file("a.exr"), levels, StorageFormat::Float), std::invalid_argument);
}

TEST_F(MapFile, TheDescriptionNeedsTheEndOfTheFile) {
    for (const bool hasLevels : {false, true})
        for (const FileKind& kind : kKinds) {
            if (hasLevels && std::string_view(kind.name).ends_with(".png"))
                continue;
            SCOPED_TRACE(kind.name);
            const std::vector<MapSet> levels =
                hasLevels ? randomLevels(100, 90) : std::vector{randomMaps(100, 90)};
            writeMapFile(file(kind.name), levels, kind.format);
            const std::string whole = readBytes(file(kind.name));
            EXPECT_EQ(readMapDescription(file(kind.name)).attributes, levels[0].attributes);
            for (const std::size_t missing : {std::size_t{1}, whole.size() / 2}) {
                writeBytes(file(kind.name), whole.substr(0, whole.size() - missing));
                EXPECT_THROW(readMapDescription(file(kind.name)), InputError) << missing;
            }
        }
}

TEST_F(MapFile, UnequalMapsGiveUnequalBytes) {
    MapSet maps = randomMaps(23, 17);
    writeMapFile(file("a.exr"), maps, StorageFormat::Float);
    maps.channels[1].plane.texels[100] += 1.0f;
    writeMapFile(file("b.exr"), maps, StorageFormat::Float);
    EXPECT_NE(readBytes(file("a.exr")), readBytes(file("b.exr")));
}

TEST_F(MapFile, KeepsTheOrderOfNamedChannels) {
    writeMapFile(file("a.exr"), randomMaps(3, 3), StorageFormat::Half);
    EXPECT_THAT(namesOf(readMapFile(file("a.exr"))), ElementsAre("depth", "dx", "dy", "cone"));
}

TEST_F(MapFile, PacksTheThesisFormInItsPlaces) {
    const MapSet maps = randomMaps(8, 8);
    writeMapFile(file("a.png"), maps, StorageFormat::U16);
    const std::vector<Plane> rgba = ImageReader(file("a.png")).readChannels(0, 4);
    const Plane depth = storedValues(maps.channels[0].plane, "depth", StorageFormat::U16);
    EXPECT_EQ(rgba[3].texels, depth.texels) << "depth in A, not multiplied by anything";
    EXPECT_THAT(namesOf(readMapFile(file("a.png"))), ElementsAre("dx", "dy", "cone", "depth"));
}

TEST_F(MapFile, LeavesHolesForMissingThesisChannels) {
    MapSet maps = randomMaps(8, 8);
    maps.channels = {maps.channels[0], maps.channels[3]};
    for (const char* name : {"a.png", "a.tif"}) {
        writeMapFile(file(name), maps, StorageFormat::U8);
        EXPECT_EQ(ImageReader(file(name)).info().channelNames.size(), 4u);
        EXPECT_THAT(namesOf(readMapFile(file(name))), ElementsAre("cone", "depth"));
    }
    maps.channels.erase(maps.channels.begin() + 1);
    writeMapFile(file("b.png"), maps, StorageFormat::U16);
    EXPECT_EQ(ImageReader(file("b.png")).info().channelNames.size(), 1u) << "depth alone is grey";
}

TEST_F(MapFile, PacksOtherChannelsInTheirOrder) {
    MapSet maps;
    maps.channels = {{"roof", randomPlane(5, 4, 0.0f, 1.0f, 1)},
                     {"ratio", randomPlane(5, 4, 0.0f, 1.0f, 2)}};
    writeMapFile(file("a.tif"), maps, StorageFormat::U16);
    const MapSet read = readMapFile(file("a.tif"));
    EXPECT_THAT(namesOf(read), ElementsAre("roof", "ratio"));
    EXPECT_EQ(read.find("ratio")->texels,
              storedValues(maps.channels[1].plane, "ratio", StorageFormat::U16).texels);
}

TEST_F(MapFile, RowZeroIsTheTopOfThePicture) {
    MapSet maps;
    maps.channels = {{"depth", Plane(4, 3)}};
    maps.channels[0].plane.at(3, 0) = 1.0f;
    for (const FileKind& kind : kKinds) {
        writeMapFile(file(kind.name), maps, kind.format);
        const Plane read = *readMapFile(file(kind.name)).find("depth");
        EXPECT_EQ(read.texels, maps.channels[0].plane.texels) << kind.name;
    }
}

TEST_F(MapFile, RefusesWhatAFileCannotHold) {
    MapSet maps = randomMaps(3, 3);
    const auto write = [&](const char* name, StorageFormat format) {
        return errorOf([&] { writeMapFile(file(name), maps, format); });
    };
    EXPECT_THAT(write("a.png", StorageFormat::Half),
                HasSubstr("a.png: cannot hold the format half"));
    EXPECT_THAT(write("a.exr", StorageFormat::U8), HasSubstr("expected the extension .png"));
    EXPECT_THAT(write("a", StorageFormat::Float), HasSubstr("expected the extension .exr"));
    maps.channels.push_back({"nx", Plane(3, 3)});
    EXPECT_THAT(write("a.png", StorageFormat::U8), HasSubstr("cannot hold 5 channels"));
    maps.channels.back().plane.texels[4] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(write("a.exr", StorageFormat::Float), HasSubstr("channel 'nx' has the value nan"));
    maps.channels.back().plane.texels[4] = 1e5f;
    EXPECT_THAT(write("a.exr", StorageFormat::Half), HasSubstr("100000, which half cannot hold"));
    EXPECT_EQ(fileCount(), 0);
}

TEST_F(MapFile, RefusesMapsThatAreNone) {
    MapSet maps = randomMaps(3, 3);
    maps.channels.push_back({"depth", Plane(3, 3)});
    EXPECT_THROW(writeMapFile(file("a.exr"), maps, StorageFormat::Float), std::invalid_argument);
    maps.channels.back() = {"nx", Plane(3, 4)};
    EXPECT_THROW(writeMapFile(file("a.exr"), maps, StorageFormat::Float), std::invalid_argument);
    EXPECT_THROW(writeMapFile(file("a.exr"), MapSet{}, StorageFormat::Float),
                 std::invalid_argument);
    maps = randomMaps(3, 3);
    maps.attributes["relievo:wrap"] = "clamp";
    EXPECT_THROW(writeMapFile(file("a.exr"), maps, StorageFormat::Float), std::invalid_argument);
}

TEST_F(MapFile, DamagedFilesAreRefusedOrRead) {
    for (const FileKind& kind : {kKinds[0], kKinds[2], kKinds[4]}) {
        writeMapFile(file(kind.name), randomMaps(9, 7), kind.format);
        const std::string whole = readBytes(file(kind.name));
        for (std::size_t position = 0; position < whole.size(); position += 23) {
            std::string damaged = whole;
            damaged[position] = static_cast<char>(damaged[position] ^ 0x55);
            writeBytes(file(kind.name), damaged);
            try {
                const MapSet read = readMapFile(file(kind.name));
                EXPECT_LE(read.width(), 32768);
            } catch (const InputError& error) {
                EXPECT_THAT(error.what(), HasSubstr(kind.name));
            }
        }
    }
}

TEST(DepthMapOf, NeedsTheChannelDepth) {
    MapSet maps = randomMaps(4, 5);
    EXPECT_EQ(depthMapOf(maps).depth.texels, maps.channels[0].plane.texels);
    EXPECT_EQ(depthMapOf(maps).wrap, WrapMode::Mirror);
    maps.channels.erase(maps.channels.begin());
    EXPECT_THAT(errorOf([&] { depthMapOf(maps); }), HasSubstr("no channel 'depth'"));
}

}  // namespace
}  // namespace relievo::textures
