#include "bench/opencv_distances.h"

#include <oneapi/tbb/global_control.h>

#include <opencv2/imgproc.hpp>

namespace relievo::bench {

namespace {

void takeThreadsOfTbb() {
    using oneapi::tbb::global_control;
    cv::setNumThreads(
        static_cast<int>(global_control::active_value(global_control::max_allowed_parallelism)));
}

// It measures to zeros, and only reads this memory.
cv::Mat distancesToZeros(const std::vector<std::uint8_t>& texels, const BakeInput& input) {
    const cv::Mat image(input.map.height(), input.map.width(), CV_8U,
                        const_cast<std::uint8_t*>(texels.data()));
    cv::Mat distances;
    cv::distanceTransform(image, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return distances;
}

}  // namespace

BakeOutput buildOpenCvDistances(const BakeInput& input) {
    takeThreadsOfTbb();
    distancesToZeros(input.lowered, input);
    return {};
}

BakeOutput buildOpenCvShape(const BakeInput& input) {
    takeThreadsOfTbb();
    const cv::Mat distances =
        distancesToZeros(input.lowered, input) - distancesToZeros(input.raised, input);
    cv::Mat slopeX;
    cv::Mat slopeY;
    cv::Sobel(distances, slopeX, CV_32F, 1, 0);
    cv::Sobel(distances, slopeY, CV_32F, 0, 1);
    return {};
}

}  // namespace relievo::bench
