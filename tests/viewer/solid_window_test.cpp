// The window of relievo-view for shapes and scenes.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/viewer/window_fixture.h"
#include "viewer/solid_panel.h"

namespace relievo::tests {
namespace {

using viewer::Picture;

constexpr std::string_view kDrawing = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 8">
  <path d="M1.5 1.5 H6.5 V3.5 H3.5 V6.5 H1.5 Z"/>
</svg>
)";

constexpr std::string_view kScene = R"({
  "camera": {"azimuth": 30, "elevation": 35, "distance": 4},
  "light": {"azimuth": -40, "elevation": 45},
  "shapes": {"ell": {"svg": "ell.svg", "size": 64}},
  "boxes": [{"size": [2, 2, 0.6], "position": [0, 0, 0.3], "colour": "#b08d57",
             "parts": [{"shape": "ell", "kind": "extrusion"}]}],
  "quads": [{"size": [4, 4]}]
}
)";

class SolidWindowTest : public WindowFixture {
  protected:
    static void SetUpTestSuite() {
        WindowFixture::SetUpTestSuite();
        std::ofstream(files_->file("ell.svg")) << kDrawing;
        std::ofstream(files_->file("ell.json")) << kScene;
    }

    static std::vector<std::string> command(const std::string& file,
                                            const std::vector<std::string>& options = {}) {
        const std::string side = std::to_string(kSize);
        // The window takes one ray a pixel.
        std::vector<std::string> words = {RELIEVO_VIEW, files_->file(file), "--rays",
                                          "1",          "--size",           side + "x" + side};
        words.insert(words.end(), options.begin(), options.end());
        return words;
    }

    static std::vector<std::string> shapeBox(const std::vector<std::string>& options = {}) {
        std::vector<std::string> all = {"--mesh", "shape-box", "--depth-scale", "0.3"};
        all.insert(all.end(), options.begin(), options.end());
        return command("ell.svg", all);
    }
};

TEST_F(SolidWindowTest, ShowsASceneAndItsOwnView) {
    const Picture scene = headless(command("ell.json"));
    ASSERT_GT(contrast(crop(scene, kMiddle)), 0.05) << "nothing to see in the scene";
    open(command("ell.json"));
    EXPECT_TRUE(shows(scene));
    const int x = corner_.first + viewer::kPanelWidth + kSize / 2;
    display_->drag(x, 300, x + 120, 330);
    EXPECT_TRUE(showsOtherThan(scene));
    display_->pressKey("r");
    EXPECT_TRUE(shows(scene));
    quit("q");
    EXPECT_TRUE(folder_.list().empty()) << "the window left files";
}

TEST_F(SolidWindowTest, ASliderChangesTheShape) {
    const Picture before = headless(shapeBox());
    const Picture wider = headless(shapeBox({"--extension", std::to_string(viewer::kMostOffset)}));
    ASSERT_LT(correlation(crop(before, kMiddle), crop(wider, kMiddle)), kDifferent);
    open(shapeBox());
    ASSERT_TRUE(shows(before));
    clickPanel(viewer::extensionSliderEnd());
    EXPECT_TRUE(shows(wider));
    quit("Escape");
}

TEST_F(SolidWindowTest, SavesThePictureOfAHeadlessRun) {
    const Picture shape = headless(shapeBox());
    open(shapeBox());
    ASSERT_TRUE(shows(shape));
    display_->pressKey("s");
    ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(folder_.file("view-001.png")); }));
    quit("q");
    EXPECT_EQ(readBytes(folder_.file("view-001.png")), readBytes(files_->file("headless.png")));
    EXPECT_EQ(folder_.list().size(), 1u);
}

TEST_F(SolidWindowTest, SavesTheWholePictureAlsoWhileItIsDrawn) {
    headless(command("ell.json"));
    open(command("ell.json"));
    display_->pressKey("s");  // before anything could be drawn
    ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(folder_.file("view-001.png")); }));
    quit("q");
    EXPECT_EQ(readBytes(folder_.file("view-001.png")), readBytes(files_->file("headless.png")));
}

}  // namespace
}  // namespace relievo::tests
