// The window of relievo-view for reliefs.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/viewer/map_fixture.h"
#include "tests/viewer/window_fixture.h"
#include "viewer/control_panel.h"
#include "viewer/window_settings.h"

namespace relievo::tests {
namespace {

using viewer::Picture;

constexpr PictureRegion kLeftOfMiddle{60, 60, kSize / 2 - 80, kSize - 120};
constexpr PictureRegion kRightOfMiddle{kSize / 2 + 20, 60, kSize / 2 - 80, kSize - 120};
// A steep relief seen at a low angle, so that techniques differ much.
const std::vector<std::string> kScene = {
    "--depth-scale", "0.35",   "--camera",
    "30,35,1.5",     "--size", std::to_string(kSize) + "x" + std::to_string(kSize)};

class WindowTest : public WindowFixture {
  protected:
    static void SetUpTestSuite() {
        WindowFixture::SetUpTestSuite();
        writeSampleMaps(files_->file("bricks.exr"), "bricks", 64, 64);
    }

    static std::vector<std::string> command(const std::vector<std::string>& options) {
        std::vector<std::string> words = {RELIEVO_VIEW, files_->file("bricks.exr")};
        words.insert(words.end(), kScene.begin(), kScene.end());
        words.insert(words.end(), options.begin(), options.end());
        return words;
    }

    static Picture headless(const std::vector<std::string>& options) {
        return WindowFixture::headless(command(options));
    }

    /// The error of `technique` as the sheet of a headless run shows it.
    static Picture headlessHeatMap(const std::string& technique) {
        constexpr int kGap = 8;
        constexpr int kLabel = 40;
        const Picture sheet =
            headless({"--technique", technique, "--error", files_->file("error.exr")});
        return crop(sheet, {kGap, kLabel + kSize + kGap + kLabel, kSize, kSize});
    }

    void open(const std::vector<std::string>& options) { WindowFixture::open(command(options)); }

    /// The place of a technique in the lists.
    static int choiceOf(std::string_view technique) {
        const auto choices = viewer::techniqueChoices();
        return static_cast<int>(std::ranges::find(choices, technique) - choices.begin());
    }

    /// Chooses a technique by its number key, or by the last of these and arrows; `modifier` is
    /// "shift+" for technique B.
    static void choose(std::string_view technique, const std::string& modifier = "") {
        const int choice = choiceOf(technique);
        if (technique == viewer::kReferenceName) {
            display_->pressKey(modifier + "0");
            return;
        }
        display_->pressKey(modifier + std::to_string(std::min(choice, 8) + 1));
        for (int k = 8; k < choice; ++k)
            display_->pressKey(modifier + "Down");
    }
};

TEST_F(WindowTest, ShowsThePictureOfAHeadlessRun) {
    const Picture relief = headless({"--technique", "relief"});
    ASSERT_GT(contrast(crop(relief, kMiddle)), 0.05) << "nothing to see in the scene";
    open({"--technique", "relief"});
    EXPECT_TRUE(shows(relief));
    quit("q");
    EXPECT_TRUE(folder_.list().empty()) << "the window left files";
}

// The measure of this file must tell techniques apart, or its tests would pass with any picture.
TEST_F(WindowTest, OtherPicturesDoNotPassForTheSame) {
    const Picture normal = headless({"--technique", "normal"});
    const Picture relief = headless({"--technique", "relief"});
    EXPECT_LT(correlation(crop(normal, kMiddle), crop(relief, kMiddle)), kDifferent);
    EXPECT_LT(correlation(Picture(kSize, kSize), relief), kDifferent);
    Picture shifted = relief;
    std::rotate(shifted.rgba.begin(), shifted.rgba.begin() + 4 * 6, shifted.rgba.end());
    EXPECT_LT(correlation(crop(shifted, kMiddle), crop(relief, kMiddle)), kDifferent);
}

TEST_F(WindowTest, TheListChangesTheTechnique) {
    const Picture normal = headless({"--technique", "normal"});
    open({"--technique", "normal"});
    ASSERT_TRUE(shows(normal));
    // The list is open when its entries cover the panel below.
    const PictureRegion below{corner_.first + 40, corner_.second + 40, 200, 60};
    const Picture closed = crop(display_->screenshot(), below);
    clickPanel(viewer::techniqueListCenter());
    ASSERT_TRUE(waitUntil([&] {
        return correlation(crop(display_->screenshot(), below), closed) < 0.9;
    })) << "the list does not open";
    clickPanel(viewer::techniqueEntryCenter(choiceOf("relief")));
    EXPECT_TRUE(shows(headless({"--technique", "relief"})));
    quit("q");
}

TEST_F(WindowTest, KeysChangeTheTechnique) {
    open({"--technique", "normal"});
    ASSERT_TRUE(shows(headless({"--technique", "normal"})));
    choose("cone");
    EXPECT_TRUE(shows(headless({"--technique", "cone"})));
    choose("linear");
    EXPECT_TRUE(shows(headless({"--technique", "linear"})));
    // Up from the first is the last of the list.
    choose("normal");
    display_->pressKey("Up");
    EXPECT_TRUE(shows(headless({"--technique", "reference"})));
    quit("Escape");
}

TEST_F(WindowTest, ShowsTheExactPicture) {
    open({"--technique", "normal"});
    choose("reference");
    EXPECT_TRUE(shows(headless({"--technique", "reference"})));
    quit("q");
}

TEST_F(WindowTest, SplitsAndComparesWithTheExactHits) {
    const Picture normal = headless({"--technique", "normal"});
    const Picture cone = headless({"--technique", "cone"});
    open({"--technique", "normal"});
    ASSERT_TRUE(shows(normal));
    choose("cone", "shift+");
    display_->pressKey("m");  // side by side: each technique in half of the width
    ASSERT_TRUE(showsOtherThan(normal));
    display_->pressKey("m");  // split
    EXPECT_TRUE(shows(normal, kLeftOfMiddle));
    EXPECT_TRUE(shows(cone, kRightOfMiddle));
    const int middle = corner_.first + viewer::kPanelWidth + kSize / 2;
    display_->drag(middle, kSize - 30, middle - kSize / 2 + 20, kSize - 30);
    EXPECT_TRUE(shows(cone));
    display_->pressKey("m");  // the error of A
    EXPECT_TRUE(shows(headlessHeatMap("normal"), {60, 60, kSize - 120, kSize - 160}));
    display_->pressKey("m");
    EXPECT_TRUE(shows(normal));
    quit("q");
}

TEST_F(WindowTest, TheMouseOrbitsAndRGoesBack) {
    const Picture relief = headless({"--technique", "relief"});
    open({"--technique", "relief"});
    ASSERT_TRUE(shows(relief));
    const int x = corner_.first + viewer::kPanelWidth + kSize / 2;
    display_->drag(x, 300, x + 100, 330);
    EXPECT_TRUE(showsOtherThan(relief));
    EXPECT_GT(contrast(crop(shown(), kMiddle)), 0.05);
    display_->pressKey("r");
    EXPECT_TRUE(shows(relief));
    quit("q");
}

TEST_F(WindowTest, SavesThePictureWithoutOverwriting) {
    open({"--technique", "normal"});
    ASSERT_TRUE(shows(headless({"--technique", "normal"})));
    const auto isSaved = [&](const char* name) {
        return waitUntil([&] { return std::filesystem::exists(folder_.file(name)); });
    };
    display_->pressKey("s");
    ASSERT_TRUE(isSaved("view-001.png"));
    const std::string first = readBytes(folder_.file("view-001.png"));
    choose("relief");
    ASSERT_TRUE(shows(headless({"--technique", "relief"})));
    display_->pressKey("s");
    ASSERT_TRUE(isSaved("view-002.png"));
    quit("q");
    EXPECT_EQ(readBytes(folder_.file("view-001.png")), first);
    EXPECT_EQ(readBytes(folder_.file("view-002.png")), readBytes(files_->file("headless.png")));
    EXPECT_EQ(folder_.list().size(), 2u);
}

TEST_F(WindowTest, WithoutTheConeChannelTheOtherTechniquesStay) {
    writeSampleMaps(files_->file("bare.exr"), "bricks", 64, 64, ConeChannel::Missing);
    std::vector<std::string> words = command({"--technique", "normal"});
    words[1] = files_->file("bare.exr");
    WindowFixture::open(words);
    const Picture normal = headless({"--technique", "normal"});
    ASSERT_TRUE(shows(normal));
    choose("cone");
    EXPECT_TRUE(waitUntil([&] { return contrast(crop(shown(), kMiddle)) < 0.02; }));
    choose("normal");
    EXPECT_TRUE(shows(normal));
    quit("q");
}

}  // namespace
}  // namespace relievo::tests
