#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/commands/process.h"
#include "tests/viewer/background_process.h"
#include "tests/viewer/picture_statistics.h"
#include "tests/viewer/virtual_display.h"
#include "viewer/panel_layout.h"

namespace relievo::tests {

/// The side of the picture in the window.
inline constexpr int kSize = 600;
/// The middle of the picture: the names of the techniques and the heat map's scale are at its
/// edges.
inline constexpr PictureRegion kMiddle{60, 60, kSize - 120, kSize - 120};
/// A screenshot of the same picture differs by the pointer at most.
inline constexpr double kSame = 0.995;
inline constexpr double kDifferent = 0.97;

/// A window of relievo-view, used for real: a program of its own under a virtual X server, worked
/// with pointer and keys, and judged by what is on the screen.
class WindowFixture : public testing::Test {
  protected:
    static void SetUpTestSuite();
    static void TearDownTestSuite();

    /// What a run without a window writes for the same words of the command line.
    static viewer::Picture headless(std::vector<std::string> words);

    /// Opens the window and waits until it has the keyboard.
    void open(const std::vector<std::string>& words);

    [[nodiscard]] viewer::Picture shown() const;

    /// Waits until a part of the window shows the same as that part of `expected`.
    testing::AssertionResult shows(const viewer::Picture& expected,
                                   const PictureRegion& part = kMiddle);
    /// Waits until the middle of the window shows something else than `picture`.
    testing::AssertionResult showsOtherThan(const viewer::Picture& picture);

    void clickPanel(const viewer::WindowPoint& point) const;
    void quit(const std::string& key);

    static std::unique_ptr<VirtualDisplay> display_;
    static std::unique_ptr<ScratchFolder> files_;  // of the suite

    ScratchFolder folder_;  // the current folder of the program
    std::unique_ptr<BackgroundProcess> view_;
    std::pair<int, int> corner_;
};

}  // namespace relievo::tests
