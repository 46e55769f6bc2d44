// relievo-bake as a process: wrong usage, bad input, full disks and interruption.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/preprocess/bake_process.h"
#include "textures/map_file.h"
#include "textures/picture_file.h"

namespace relievo::preprocess {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::ProcessOptions;
using tests::ProcessResult;
using tests::ScratchFolder;
using textures::Plane;

class BadInput : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& bytes) {
        std::ofstream(folder.file(name), std::ios::binary) << bytes;
    }

    std::string goodHeight() {
        const std::string file = folder.file("height.png");
        EXPECT_EQ(bake({"sample", "noise", "-o", file, "--size", "256x256"}).exitStatus, 0);
        return file;
    }

    // Exit status 1, one sentence that names `culprit`, and a folder as before.
    void expectRefused(const std::vector<std::string>& arguments, const std::string& culprit,
                       const ProcessOptions& options = {}) {
        const std::vector<std::string> before = folder.list();
        const ProcessResult result = bake(arguments, options);
        EXPECT_EQ(result.exitStatus, 1) << culprit;
        EXPECT_THAT(result.errors, testing::StartsWith("relievo-bake: "));
        EXPECT_THAT(result.errors, HasSubstr(culprit));
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
        EXPECT_EQ(folder.list(), before) << culprit;
    }
    void expectRefusedImage(const std::string& name) {
        expectRefused({"relief", folder.file(name), "-o", folder.file("out.exr")}, name);
        expectRefused({"info", folder.file(name)}, name);
    }

    ScratchFolder folder;
};

TEST_F(BadInput, MissingForeignEmptyAndFolders) {
    expectRefusedImage("missing.png");
    write("notes.png", "This is no image.\n");
    expectRefusedImage("notes.png");
    write("empty.png", "");
    expectRefusedImage("empty.png");
    std::filesystem::create_directory(folder.file("folder.png"));
    expectRefusedImage("folder.png");
}

TEST_F(BadInput, TruncatedImages) {
    for (const std::string extension : {".png", ".tif", ".exr"}) {
        const std::string whole = folder.file("whole" + extension);
        ASSERT_EQ(bake({"sample", "noise", "-o", whole, "--size", "64x64"}).exitStatus, 0);
        const std::string bytes = tests::readBytes(whole);
        for (const std::size_t parts : {1u, 2u, 3u}) {
            write("cut" + extension, bytes.substr(0, bytes.size() * parts / 4));
            expectRefusedImage("cut" + extension);
        }
    }
}

TEST_F(BadInput, ImagesOfNoSize) {
    std::string bytes = tests::readBytes(goodHeight());
    std::fill_n(bytes.begin() + 16, 4, '\0');  // the width in the header of a PNG
    write("narrow.png", bytes);
    expectRefusedImage("narrow.png");
    write("empty.pgm", "P5\n0 0\n255\n");
    expectRefusedImage("empty.pgm");
}

TEST_F(BadInput, ValuesThatAreNoHeights) {
    for (const float value : {std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::infinity(), -0.5f, 7.0f}) {
        Plane plane(5, 4, 0.5f);
        plane.at(2, 1) = value;
        textures::writePicture(folder.file("odd.exr"), std::array{plane},
                               textures::StorageFormat::Float);
        expectRefused({"relief", folder.file("odd.exr"), "-o", folder.file("out.exr")}, "odd.exr");
    }
}

TEST_F(BadInput, ChannelThatIsNotThere) {
    expectRefused({"relief", goodHeight(), "-o", folder.file("out.exr"), "--channel", "Z"}, "'Z'");
}

TEST_F(BadInput, FoldersThatCannotBeWritten) {
    const std::string height = goodHeight();
    for (const std::string& target :
         {folder.file("missing/out.exr"), height + "/out.exr", std::string("/proc/out.exr")})
        expectRefused({"relief", height, "-o", target}, "out.exr");
    std::filesystem::create_directory(folder.file("taken.exr"));
    expectRefused({"relief", height, "-o", folder.file("taken.exr")}, "taken.exr");
}

TEST_F(BadInput, FilesThatGrowTooLarge) {
    const std::string height = goodHeight();
    ProcessOptions options;
    options.fileSizeLimit = 50000;
    for (const std::string extension : {".exr", ".png", ".tif"})
        expectRefused({"relief", height, "-o", folder.file("out" + extension), "--quiet"},
                      "out" + extension, options);
}

TEST_F(BadInput, FullDisk) {
    const std::string height = goodHeight();
    const std::string disk = folder.file("disk");
    std::filesystem::create_directory(disk);
    if (mount("none", disk.c_str(), "tmpfs", 0, "size=64k") != 0) {
        std::puts("no rights to mount a small disk: FilesThatGrowTooLarge stands for it");
        return;
    }
    for (const std::string extension : {".exr", ".png", ".tif"}) {
        expectRefused({"relief", height, "-o", disk + "/out" + extension, "--quiet"},
                      "out" + extension);
        EXPECT_TRUE(std::filesystem::is_empty(disk)) << extension;
    }
    EXPECT_EQ(umount(disk.c_str()), 0);
}

TEST_F(BadInput, AnOldOutputSurvivesAFailure) {
    write("out.exr", "old");
    ProcessOptions options;
    options.fileSizeLimit = 50000;
    expectRefused({"relief", goodHeight(), "-o", folder.file("out.exr"), "--quiet"}, "out.exr",
                  options);
    EXPECT_EQ(tests::readBytes(folder.file("out.exr")), "old");
}

TEST_F(BadInput, WrongUsageIsStatusTwoBeforeAnyWork) {
    const std::string height = goodHeight();
    const std::string out = folder.file("out.exr");
    const std::vector<std::vector<std::string>> wrong = {
        {},
        {"relief"},
        {"relief", height},
        {"relief", height, "-o", folder.file("out.jpg")},
        {"relief", height, "-o", folder.file("out.png"), "--format", "half"},
        {"relief", height, "-o", out, "--format", "u16"},
        {"relief", height, "-o", folder.file("out.png"), "--maps", "normal,cone,depth"},
        {"relief", height, "-o", out, "--maps", "depth,colour"},
        {"relief", height, "-o", out, "--maps", ""},
        {"relief", height, "-o", out, "--maps", "cone", "--guarantee", "texel", "--encode",
         "radius"},
        {"relief", height, "-o", out, "--cone", "conservative", "--encode", "radius"},
        {"relief", height, "-o", out, "--encode", "sqrt"},
        {"relief", height, "-o", out, "--cone", "roof", "--method", "levels"},
        {"relief", height, "-o", out, "--cone", "roof", "--sectors", "3"},
        {"relief", height, "-o", out, "--cone", "conservative", "--sectors", "4"},
        {"relief", height, "-o", out, "--cone", "relaxed", "--method", "maxima", "--sectors", "4"},
        {"relief", height, "-o", folder.file("out.png"), "--cone", "relaxed", "--sectors", "4"},
        {"relief", height, "-o", folder.file("out.png"), "--cone", "roof"},
        {"relief", height, "-o", out, "--cone", "conservative", "--method", "maxima"},
        {"relief", height, "-o", out, "--guarantee", "bilinear", "--method", "squares"},
        {"relief", height, "-o", out, "--wrap", "tile"},
        {"relief", height, "-o", out, "--threads", "0"},
        {"relief", height, "-o", out, "--normal-scale", "-1"},
        {"relief", height, "-o", out, "--normal-scale", "nan"},
        {"relief", height, "-o", out, "--maps", "volume", "--slices", "0"},
        {"relief", height, "-o", out, "--maps", "volume", "--volume-scale", "0"},
        {"relief", height, "-o", folder.file("out.png"), "--maps", "volume"},
        {"relief", height, "-o", out, "--maps", "horizon", "--azimuths", "2"},
        {"relief", height, "-o", out, "--maps", "extrema", "--reach", "-1"},
        {"relief", height, "-o", out, "--maps", "vdm", "--vdm-curvatures", "4"},
        {"relief", height, "-o", out, "--maps", "vdm", "--mips"},
        {"relief", height, "-o", folder.file("out.png"), "--maps", "vdm"},
        {"relief", height, "-o", height},
        {"info"},
        {"sample", "noise"},
        {"sample", "moon", "-o", out},
        {"sample", "noise", "-o", out, "--size", "0x5"},
        {"sample", "noise", "-o", out, "--size", "5"},
    };
    for (const std::vector<std::string>& arguments : wrong) {
        const ProcessResult result = bake(arguments);
        const std::string command = testing::PrintToString(arguments);
        EXPECT_EQ(result.exitStatus, 2) << command;
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << command;
        EXPECT_THAT(folder.list(), ElementsAre("height.png")) << command;
    }
}

// Interrupted later and later, until it ends before the signal.
TEST_F(BadInput, InterruptionAtAnyTimeLeavesNothingOrAWholeFile) {
    const std::string height = goodHeight();
    const std::string out = folder.file("out.exr");
    int interruptions = 0;
    for (int delay = 20;; delay = delay * 3 / 2) {
        ProcessOptions options;
        options.signalAfter = std::chrono::milliseconds(delay);
        options.signal = interruptions % 2 == 0 ? SIGINT : SIGTERM;
        const ProcessResult result = bake({"relief", height, "-o", out, "--quiet"}, options);
        if (result.exitStatus == 0)
            break;
        ++interruptions;
        // The system's own end of a program whose handlers are not there yet is as good.
        EXPECT_TRUE(result.exitStatus == 128 + options.signal || result.killedBy == options.signal)
            << result.exitStatus << " " << result.errors;
        // The signal may come between the last rename and the end. Depth, two derivatives, and roof
        // and ratio of four sectors:
        if (std::filesystem::exists(out)) {
            EXPECT_EQ(textures::readMapFile(out).channels.size(), 11u);
            std::filesystem::remove(out);
        }
        EXPECT_THAT(folder.list(), ElementsAre("height.png")) << delay << " ms";
    }
    EXPECT_GT(interruptions, 0);
}

TEST_F(BadInput, InterruptionWhileWritingLeavesNothing) {
    const std::string height = folder.file("height.png");
    ASSERT_EQ(bake({"sample", "wave", "-o", height, "--size", "1024x1024"}).exitStatus, 0);
    ProcessOptions options;
    options.signalWhen = [&](const std::string&) {  // the temporary file has its first bytes
        for (const std::string& name : folder.list()) {
            std::error_code gone;
            if (name != "height.png" &&
                std::filesystem::file_size(folder.path() / name, gone) > 0 && !gone)
                return true;
        }
        return false;
    };
    const ProcessResult result = bake(
        {"relief", height, "-o", folder.file("out.exr"), "--quiet", "--maps", "depth,derivative"},
        options);
    EXPECT_EQ(result.exitStatus, 130) << result.errors;
    EXPECT_THAT(folder.list(), ElementsAre("height.png"));
}

}  // namespace
}  // namespace relievo::preprocess
