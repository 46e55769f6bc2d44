#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/commands/process.h"
#include "tests/viewer/background_process.h"
#include "viewer/picture.h"

namespace relievo::tests {

/// An X server of its own without a screen of glass (Xvfb), 1024×768 pixels, and hands to use it
/// with (xdotool).
class VirtualDisplay {
  public:
    /// Throws std::runtime_error when the server does not start.
    VirtualDisplay();

    /// Runs `command` in the background with this display.
    [[nodiscard]] std::vector<std::string> withDisplay(std::vector<std::string> command) const;
    /// All that is on the screen. Sees the memory of the server, so nothing has to be asked for.
    [[nodiscard]] viewer::Picture screenshot() const;

    /// Waits for a window whose title begins with `title` and gives it the keyboard; there is no
    /// window manager to do it. Returns its upper left corner, or nothing when it does not come.
    [[nodiscard]] std::optional<std::pair<int, int>> focusWindow(const std::string& title) const;

    void pressKey(const std::string& key) const;
    void click(int x, int y) const;
    /// Presses the left button at one place and releases it at another.
    void drag(int fromX, int fromY, int toX, int toY) const;

  private:
    /// Runs xdotool; returns what it printed, or nothing when it failed.
    std::optional<std::string> xdotool(const std::vector<std::string>& arguments) const;

    ScratchFolder folder_;
    std::string name_;  // ":7"
    std::optional<BackgroundProcess> server_;
};

}  // namespace relievo::tests
