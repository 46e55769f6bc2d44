#include "viewer/reference_worker.h"

#include <gtest/gtest.h>

#include <random>
#include <semaphore>

#include "textures/sample_reliefs.h"

namespace relievo::viewer {
namespace {

constexpr glm::vec4 kEverywhere{-1e6f, -1e6f, 1e6f, 1e6f};
constexpr int kNoLight = 0;  // rays to the light

// Rays from random places of the reference surface, downwards.
MeasuredFrame randomRays(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    MeasuredFrame frame{width, height, {}};
    frame.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (MeasuredPixel& pixel : frame.pixels) {
        pixel.covered = unit(random) < 0.9f;
        pixel.origin = {unit(random), unit(random), 0};
        pixel.direction = {2 * unit(random) - 1, 2 * unit(random) - 1, unit(random) + 0.1f};
    }
    return frame;
}

bool sameHits(const ReferenceFrame& a, const ReferenceFrame& b) {
    return a.width == b.width && a.height == b.height &&
           std::equal(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), b.pixels.end(),
                      [](const ReferencePixel& p, const ReferencePixel& q) {
                          return p.covered == q.covered && p.hit == q.hit && p.t == q.t &&
                                 p.position == q.position && p.normal == q.normal;
                      });
}

TEST(ReferenceWorker, GivesWhatTraceReferenceGives) {
    const textures::DepthMap map = textures::generateSampleRelief("cobbles", 48, 31);
    std::counting_semaphore<> done(0);
    ReferenceWorker worker([&] { done.release(); });
    EXPECT_FALSE(worker.isBusy());
    // One row, one column, and more rows than one band of the worker has.
    const int sizes[][2] = {{1, 1}, {1, 97}, {97, 1}, {211, 101}};
    for (const auto& [width, height] : sizes) {
        const MeasuredFrame rays = randomRays(width, height, 3);
        worker.start(rays, map, kEverywhere, 0.2, kNoLight);
        EXPECT_TRUE(worker.isBusy());
        done.acquire();
        const auto frame = worker.take();
        ASSERT_TRUE(frame);
        EXPECT_EQ(worker.progress(), 1.0f);
        EXPECT_FALSE(worker.isBusy());
        EXPECT_FALSE(worker.take()) << "a frame is handed over once";
        EXPECT_TRUE(sameHits(*frame, traceReference(rays, map, kEverywhere, 0.2)));
        // The comparison would notice other rays.
        EXPECT_FALSE(
            sameHits(*frame, traceReference(randomRays(width, height, 4), map, kEverywhere, 0.2)));
    }
}

TEST(ReferenceWorker, TheLastStartWinsAndACancelledFrameNeverComes) {
    const textures::DepthMap map = textures::generateSampleRelief("noise", 64, 64);
    std::counting_semaphore<> done(0);
    ReferenceWorker worker([&] { done.release(); });
    const MeasuredFrame last = randomRays(40, 30, 9);
    for (unsigned seed = 0; seed < 5; ++seed)
        worker.start(randomRays(512, 512, seed), map, kEverywhere, 0.2, kNoLight);
    worker.start(last, map, kEverywhere, 0.2, kNoLight);
    for (int frames = 0; frames < 6; ++frames)
        done.acquire();
    const auto frame = worker.take();
    ASSERT_TRUE(frame);
    EXPECT_TRUE(sameHits(*frame, traceReference(last, map, kEverywhere, 0.2)));

    worker.start(last, map, kEverywhere, 0.2, kNoLight);
    worker.cancel();
    EXPECT_FALSE(worker.isBusy());
    EXPECT_FALSE(worker.take());
}

TEST(ReferenceWorker, EndsInTheMiddleOfWork) {
    const textures::DepthMap map = textures::generateSampleRelief("noise", 64, 64);
    ReferenceWorker worker([] {});
    worker.start(randomRays(1024, 1024, 1), map, kEverywhere, 0.2, kNoLight);
}

}  // namespace
}  // namespace relievo::viewer
