#include "viewer/temporal_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "textures/srgb.h"

namespace relievo::viewer {
using textures::linearFromSrgb;

double luminance(const float* pixel) {
    return 0.2126 * linearFromSrgb(static_cast<double>(pixel[0])) +
           0.7152 * linearFromSrgb(static_cast<double>(pixel[1])) +
           0.0722 * linearFromSrgb(static_cast<double>(pixel[2]));
}

Picture averaged(const Picture& fine, int samples) {
    assert(samples >= 1 && fine.width % samples == 0 && fine.height % samples == 0);
    Picture result(fine.width / samples, fine.height / samples);
    const double share = 1.0 / (1.0 * samples * samples);
    tbb::parallel_for(0, result.height, [&](int y) {
        for (int x = 0; x < result.width; ++x) {
            double sums[3] = {};
            for (int j = 0; j < samples; ++j)
                for (int i = 0; i < samples; ++i)
                    for (int c = 0; c < 3; ++c)
                        sums[c] += linearFromSrgb(
                            static_cast<double>(fine.pixel(x * samples + i, y * samples + j)[c]));
            for (int c = 0; c < 3; ++c)
                result.pixel(x, y)[c] =
                    static_cast<float>(textures::srgbFromLinear(sums[c] * share));
            result.pixel(x, y)[3] = 1.0f;
        }
    });
    return result;
}

void TemporalError::add(const Picture& frame, const Picture& truth) {
    assert(frame.width == truth.width && frame.height == truth.height);
    const std::size_t pixels = frame.rgba.size() / 4;
    sums_.resize(pixels);
    squares_.resize(pixels);
    for (std::size_t k = 0; k < pixels; ++k) {
        const double error = luminance(&frame.rgba[4 * k]) - luminance(&truth.rgba[4 * k]);
        sums_[k] += error;
        squares_[k] += error * error;
    }
    ++frames_;
}

TemporalErrorStatistics TemporalError::statistics() const {
    assert(frames_ >= 2);
    const auto frames = static_cast<double>(frames_);
    const auto pixels = static_cast<double>(sums_.size());
    TemporalErrorStatistics result;
    double variances = 0.0;
    double means = 0.0;
    for (std::size_t k = 0; k < sums_.size(); ++k) {
        const double mean = sums_[k] / frames;
        variances += std::max(squares_[k] / frames - mean * mean, 0.0) * frames / (frames - 1.0);
        means += mean * mean;
        result.bias += mean / pixels;
    }
    result.sparkle = std::sqrt(variances / pixels);
    result.lasting = std::sqrt(means / pixels);
    return result;
}

}  // namespace relievo::viewer
