#include "viewer/heat_map.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>

#include "viewer/picture_text.h"

namespace relievo::viewer {
namespace {

constexpr std::array kStops = {glm::vec3(0.02f, 0.02f, 0.04f), glm::vec3(0.28f, 0.09f, 0.46f),
                               glm::vec3(0.73f, 0.18f, 0.33f), glm::vec3(0.98f, 0.55f, 0.12f),
                               glm::vec3(0.99f, 1.00f, 0.90f)};
constexpr glm::vec3 kMismatchColor{0.0f, 0.85f, 0.9f};
constexpr glm::vec3 kExhaustedColor{1.0f, 0.0f, 1.0f};
constexpr glm::vec3 kUncoveredColor{0.2f, 0.2f, 0.21f};

glm::vec3 scaleColor(float position) {
    const float scaled = std::clamp(position, 0.0f, 1.0f) * static_cast<float>(kStops.size() - 1);
    const auto stop = std::min(static_cast<std::size_t>(scaled), kStops.size() - 2);
    return glm::mix(kStops[stop], kStops[stop + 1], scaled - static_cast<float>(stop));
}

void setPixel(Picture& picture, int x, int y, glm::vec3 color) {
    float* pixel = picture.pixel(x, y);
    for (int c = 0; c < 3; ++c)
        pixel[c] = color[c];
    pixel[3] = 1.0f;
}

glm::vec3 verdictColor(PixelVerdict verdict, float texels) {
    switch (verdict) {
        case PixelVerdict::Uncovered:
            return kUncoveredColor;
        case PixelVerdict::Mismatch:
            return kMismatchColor;
        case PixelVerdict::Exhausted:
            return kExhaustedColor;
        case PixelVerdict::Compared:
            break;
    }
    return heatColor(texels);
}

}  // namespace

glm::vec3 heatColor(float texels) {
    const float error = std::max(std::abs(texels), kHeatMinimum);
    return scaleColor(std::log2(error / kHeatMinimum) / std::log2(kHeatMaximum / kHeatMinimum));
}

Picture heatMap(const ErrorImage& image) {
    Picture picture(image.distance.width, image.distance.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto verdict =
                static_cast<PixelVerdict>(static_cast<int>(image.verdict.at(x, y)));
            setPixel(picture, x, y, verdictColor(verdict, image.distance.at(x, y)));
        }
    return picture;
}

Picture heatScale(int width) {
    assert(width >= 300);
    Picture picture(width, kHeatScaleHeight);
    constexpr int kBarTop = 4;
    constexpr int kBarBottom = 18;
    constexpr int kMargin = 12;
    const int barWidth = width - 2 * kMargin;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool bar =
                y >= kBarTop && y < kBarBottom && x >= kMargin && x < kMargin + barWidth;
            const float position =
                static_cast<float>(x - kMargin) / static_cast<float>(barWidth - 1);
            setPixel(picture, x, y, bar ? scaleColor(position) : glm::vec3(0.13f));
        }
    const auto label = [&](float fraction, const char* text) {
        const int x = kMargin + static_cast<int>(fraction * static_cast<float>(barWidth));
        drawText(picture, text, x - (fraction > 0.9f ? textWidth(text, 11) : 0), 32, 11,
                 glm::vec3(0.9f));
    };
    label(0.0f, "1/64 texel");
    label(0.5f, "1");
    label(1.0f, "64 texels");
    drawText(picture, "hit/miss differ", kMargin + barWidth / 4, 32, 11, kMismatchColor);
    drawText(picture, "steps ran out", kMargin + barWidth * 6 / 10, 32, 11, kExhaustedColor);
    return picture;
}

}  // namespace relievo::viewer
