#include "tests/viewer/virtual_display.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace relievo::tests {
namespace {

// The fields of the X Window dump format (X11/XWDFile.h) that are needed, by their place in the
// header of 32-bit big-endian numbers.
enum HeaderField {
    kHeaderSize = 0,
    kWidth = 4,
    kHeight = 5,
    kBitsPerPixel = 11,
    kRowBytes = 12,
    kColors = 19
};
constexpr std::size_t kColorBytes = 12;

std::uint32_t headerField(const std::string& dump, HeaderField field) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k)
        value = value << 8 | static_cast<unsigned char>(dump.at(4 * field + k));
    return value;
}

viewer::Picture parseDump(const std::string& dump) {
    if (headerField(dump, kBitsPerPixel) != 32)
        throw std::runtime_error("the virtual display has no 32 bits a pixel");
    viewer::Picture picture(static_cast<int>(headerField(dump, kWidth)),
                            static_cast<int>(headerField(dump, kHeight)));
    const std::size_t start =
        headerField(dump, kHeaderSize) + kColorBytes * headerField(dump, kColors);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::size_t offset = start +
                                       static_cast<std::size_t>(y) * headerField(dump, kRowBytes) +
                                       4 * static_cast<std::size_t>(x);
            for (std::size_t c = 0; c < 3; ++c)  // blue first
                picture.pixel(x, y)[2 - c] =
                    static_cast<float>(static_cast<unsigned char>(dump.at(offset + c))) / 255.0f;
            picture.pixel(x, y)[3] = 1.0f;
        }
    return picture;
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
    // The server chooses a free number and writes it when it is ready.
    const std::string number = folder_.file("number");
    server_.emplace(std::vector<std::string>{
        "sh", "-c",
        "exec Xvfb -displayfd 3 -screen 0 1024x768x24 -nolisten tcp -fbdir \"$1\" 3>\"$1/number\" "
        "2>\"$1/log\"",
        "sh", folder_.path().string()});
    const bool started = waitUntil([&] {
        if (server_->status())
            return true;
        std::ifstream stream(number);
        std::string text;
        // The line is complete only with its end.
        return std::getline(stream, text) && !stream.eof() && !(name_ = ":" + text).empty();
    });
    if (!started || server_->status())
        throw std::runtime_error("Xvfb does not start: " + readBytes(folder_.file("log")));
}

std::vector<std::string> VirtualDisplay::withDisplay(std::vector<std::string> command) const {
    // Software rendering, as without a display, so that pictures can be compared.
    command.insert(command.begin(), {"env", "DISPLAY=" + name_, "LIBGL_ALWAYS_SOFTWARE=1"});
    return command;
}

viewer::Picture VirtualDisplay::screenshot() const {
    return parseDump(readBytes(folder_.file("Xvfb_screen0")));
}

std::optional<std::string> VirtualDisplay::xdotool(
    const std::vector<std::string>& arguments) const {
    std::vector<std::string> command = {"/usr/bin/timeout", std::to_string(kPatience.count()),
                                        "env", "DISPLAY=" + name_, "xdotool"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProcessResult result = runProcess(command);
    if (result.exitStatus != 0)
        return std::nullopt;
    return result.output;
}

std::optional<std::pair<int, int>> VirtualDisplay::focusWindow(const std::string& title) const {
    const auto found = xdotool({"search", "--sync", "--onlyvisible", "--name", "^" + title});
    if (!found)
        return std::nullopt;
    const std::string id = found->substr(0, found->find('\n'));
    const auto place = xdotool({"getwindowgeometry", "--shell", id});
    if (!place || !xdotool({"windowfocus", "--sync", id}))
        return std::nullopt;
    std::pair<int, int> corner;
    std::istringstream lines(*place);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("X="))
            corner.first = std::stoi(line.substr(2));
        if (line.starts_with("Y="))
            corner.second = std::stoi(line.substr(2));
    }
    return corner;
}

void VirtualDisplay::pressKey(const std::string& key) const {
    if (!xdotool({"key", key}))
        throw std::runtime_error("xdotool cannot press " + key);
}

void VirtualDisplay::click(int x, int y) const {
    if (!xdotool({"mousemove", std::to_string(x), std::to_string(y), "click", "1"}))
        throw std::runtime_error("xdotool cannot click");
}

void VirtualDisplay::drag(int fromX, int fromY, int toX, int toY) const {
    // In two steps, because a viewer reads the difference to where the pointer was.
    const auto middle = [](int from, int to) { return std::to_string((from + to) / 2); };
    if (!xdotool({"mousemove",
                  std::to_string(fromX),
                  std::to_string(fromY),
                  "sleep",
                  "0.2",
                  "mousedown",
                  "1",
                  "sleep",
                  "0.2",
                  "mousemove",
                  middle(fromX, toX),
                  middle(fromY, toY),
                  "sleep",
                  "0.2",
                  "mousemove",
                  std::to_string(toX),
                  std::to_string(toY),
                  "sleep",
                  "0.2",
                  "mouseup",
                  "1"}))
        throw std::runtime_error("xdotool cannot drag");
}

}  // namespace relievo::tests
