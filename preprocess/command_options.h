#pragma once

#include <tbb/global_control.h>

#include <chrono>
#include <string>

#include "textures/storage_format.h"

namespace relievo::preprocess {

/// What the subcommands of relievo-bake have in common.

inline constexpr int kMostThreads = 1024;

/// Sides in texels.
struct MapSize {
    int width = 0;
    int height = 0;
};

/// "512x256". Throws UsageError for anything but two whole numbers from 1 to `largest`.
MapSize parseSize(const std::string& text, int largest);

/// The format called `format`, or without one the usual of the extension: Float for .exr, U16 for
/// .png and .tif. Throws UsageError when `output` cannot hold it.
textures::StorageFormat outputFormat(const std::string& output, const std::string& format);

/// Holds oneTBB to so many threads while it lives; 0: all cores.
tbb::global_control limitThreads(int threads);

/// Times a stage and says what it did when it is over.
class Stage {
  public:
    explicit Stage(std::string name);
    void done(const std::string& counts) const;

  private:
    std::string name_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace relievo::preprocess
