#include "textures/map_metadata.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "temporary_folder.h"
#include "textures/image_writer.h"
#include "textures/map_file.h"

namespace relievo::textures {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// Writes images that are nearly map files.
class MapMetadata : public TemporaryFolder {
  protected:
    static ImageContent goodContent(StorageFormat format) {
        ImageContent content;
        content.format = format;
        content.planes = {Plane(2, 2), Plane(2, 2), Plane(2, 2)};
        if (!isPackedFormat(format))
            content.channelNames = {"cone", "depth", "dx"};
        content.attributes = {{"relievo:kind", "relief"},
                              {"relievo:wrap", "repeat"},
                              {"relievo:encoding", "ratio"},
                              {"relievo:channels", "cone depth dx"},
                              {"relievo:scale", "cone=0:1 depth=0:1 dx=-128:127"}};
        return content;
    }
    std::string errorWith(StorageFormat format, const std::function<void(ImageContent&)>& change) {
        ImageContent content = goodContent(format);
        change(content);
        const std::filesystem::path path = file(isPackedFormat(format) ? "m.png" : "m.exr");
        writeImage(path, content);
        const std::string message = errorOf([&] { readMapFile(path); });
        EXPECT_THAT(message, StartsWith(path.string() + ": "));
        return message;
    }
    std::string errorWithAttribute(StorageFormat format, const std::string& name,
                                   const std::string& value) {
        return errorWith(format, [&](ImageContent& content) { content.attributes[name] = value; });
    }
};

TEST_F(MapMetadata, TheUnchangedFilesAreGood) {
    for (const StorageFormat format : {StorageFormat::U8, StorageFormat::Float}) {
        const std::filesystem::path path = file(isPackedFormat(format) ? "m.png" : "m.exr");
        writeImage(path, goodContent(format));
        EXPECT_EQ(readMapFile(path).channels.size(), 3u);
    }
}

TEST_F(MapMetadata, MissingAttributesAreNamed) {
    for (const char* name :
         {"relievo:kind", "relievo:wrap", "relievo:encoding", "relievo:channels"})
        for (const StorageFormat format : {StorageFormat::U8, StorageFormat::Float})
            EXPECT_THAT(errorWith(format, [&](ImageContent& c) { c.attributes.erase(name); }),
                        HasSubstr("lacks the attribute '" + std::string(name) + "'"));
    EXPECT_THAT(
        errorWith(StorageFormat::U8, [](ImageContent& c) { c.attributes.erase("relievo:scale"); }),
        HasSubstr("lacks the attribute 'relievo:scale'"));
}

TEST_F(MapMetadata, SenselessAttributesAreNamed) {
    EXPECT_THAT(errorWithAttribute(StorageFormat::Float, "relievo:wrap", "tile"),
                HasSubstr("'relievo:wrap' is 'tile', expected repeat, mirror or clamp"));
    EXPECT_THAT(errorWithAttribute(StorageFormat::Float, "relievo:encoding", "angle"),
                HasSubstr("'relievo:encoding' is 'angle', expected ratio, radius or sqrt"));
    EXPECT_THAT(errorWithAttribute(StorageFormat::Float, "relievo:channels", "dx dx depth"),
                HasSubstr("expected each channel once"));
    EXPECT_THAT(errorWithAttribute(StorageFormat::U8, "relievo:channels", "- - -"),
                HasSubstr("expected the names of the channels"));
}

TEST_F(MapMetadata, SenselessScalesAreRefused) {
    for (const char* scale : {"cone", "cone=0", "cone=0:x", "cone=1:0", "cone=0:inf", "cone=0:1e",
                              "cone=nan:1", "cone=0:0", "cone=-1e308:1e308"})
        EXPECT_THAT(errorWithAttribute(StorageFormat::U8, "relievo:scale", scale),
                    HasSubstr("'relievo:scale' is '" + std::string(scale) + "'"));
    EXPECT_THAT(errorWithAttribute(StorageFormat::U8, "relievo:scale", "cone=0:1 depth=0:1"),
                HasSubstr("'relievo:scale' lacks the channel 'dx'"));
}

TEST_F(MapMetadata, MissingChannelsAreNamed) {
    EXPECT_THAT(errorWithAttribute(StorageFormat::Float, "relievo:channels", "cone depth dy"),
                HasSubstr("lacks the channel 'dy'"));
    EXPECT_THAT(errorWithAttribute(StorageFormat::U8, "relievo:channels", "cone depth"),
                HasSubstr("has 3 channels, expected the 2 of"));
}

TEST_F(MapMetadata, SenselessValuesAreNamed) {
    const auto withValue = [&](std::size_t channel, float value) {
        return errorWith(StorageFormat::Float,
                         [&](ImageContent& content) { content.planes[channel].texels[3] = value; });
    };
    EXPECT_THAT(withValue(1, 1.5f),
                HasSubstr("channel 'depth' has the value 1.5, expected 0 to 1"));
    EXPECT_THAT(withValue(0, -0.5f), HasSubstr("channel 'cone' has the value -0.5"));
    EXPECT_THAT(withValue(2, std::numeric_limits<float>::quiet_NaN()), HasSubstr("'dx'"));
    EXPECT_THAT(withValue(2, std::numeric_limits<float>::infinity()), HasSubstr("finite values"));
    EXPECT_THAT(
        errorWithAttribute(StorageFormat::U8, "relievo:scale", "cone=0:1 depth=-1:1 dx=-128:127"),
        HasSubstr("channel 'depth' has the value -1"));
}

TEST_F(MapMetadata, ScalesComeBackToTheLastDigit) {
    const ChannelRanges ranges{{"dx", {-0.1, 1.0 / 3.0}}, {"dy", {-1e-300, 1e300}}};
    const ChannelRanges read =
        rangesFromAttributes(describeMaps(MapSet{}, {"dx", "dy"}, ranges), "file");
    ASSERT_EQ(read.size(), 2u);
    for (const auto& [name, range] : ranges) {
        EXPECT_EQ(read.at(name).low, range.low);
        EXPECT_EQ(read.at(name).high, range.high);
    }
}

}  // namespace
}  // namespace relievo::textures
