#include "tests/viewer/window_fixture.h"

namespace relievo::tests {

using viewer::Picture;

std::unique_ptr<VirtualDisplay> WindowFixture::display_;
std::unique_ptr<ScratchFolder> WindowFixture::files_;

void WindowFixture::SetUpTestSuite() {
    display_ = std::make_unique<VirtualDisplay>();
    files_ = std::make_unique<ScratchFolder>();
}

void WindowFixture::TearDownTestSuite() {
    display_.reset();
    files_.reset();
}

Picture WindowFixture::headless(std::vector<std::string> words) {
    const std::string file = files_->file("headless.png");
    words.insert(words.end(), {"--headless", "-o", file});
    const ProcessResult result = runProcess(words);
    EXPECT_EQ(result.exitStatus, 0) << result.errors;
    return viewer::readPicture(file);
}

void WindowFixture::open(const std::vector<std::string>& words) {
    view_ = std::make_unique<BackgroundProcess>(display_->withDisplay(words), folder_.path());
    const auto corner = display_->focusWindow("Relievo");
    ASSERT_TRUE(corner) << "no window";
    corner_ = *corner;
}

Picture WindowFixture::shown() const {
    return crop(display_->screenshot(),
                {corner_.first + viewer::kPanelWidth, corner_.second, kSize, kSize});
}

testing::AssertionResult WindowFixture::shows(const Picture& expected, const PictureRegion& part) {
    const Picture wanted = crop(expected, part);
    double last = 0.0;
    if (waitUntil([&] {
            last = correlation(crop(shown(), part), wanted);
            return last > kSame || view_->status();
        }) &&
        !view_->status())
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "correlation " << last;
}

testing::AssertionResult WindowFixture::showsOtherThan(const Picture& picture) {
    const Picture middle = crop(picture, kMiddle);
    if (waitUntil([&] { return correlation(crop(shown(), kMiddle), middle) < kDifferent; }))
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "still the same picture";
}

void WindowFixture::clickPanel(const viewer::WindowPoint& point) const {
    display_->click(corner_.first + point.x, corner_.second + point.y);
}

void WindowFixture::quit(const std::string& key) {
    display_->pressKey(key);
    ASSERT_TRUE(waitUntil([&] { return view_->status().has_value(); })) << "still open";
    EXPECT_EQ(*view_->status(), 0);
}

}  // namespace relievo::tests
