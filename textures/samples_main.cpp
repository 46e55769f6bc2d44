// Writes the bundled sample reliefs, `NAME-height.png` and `NAME-albedo.png`, into the folder that
// the first argument names. A developer's tool: run it after a change of the generators.

#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "textures/bundled_samples.h"
#include "textures/picture_file.h"
#include "textures/sample_albedo.h"
#include "textures/sample_reliefs.h"

using namespace relievo::textures;

namespace {

void writeSample(const std::filesystem::path& folder, const BundledSample& sample) {
    const std::string name(sample.name);
    Plane height = generateSampleRelief(name, sample.size, sample.size).depth;
    for (float& value : height.texels)
        value = 1.0f - value;
    writePicture(folder / (name + "-height.png"), std::array{height}, StorageFormat::U16);
    writePicture(folder / (name + "-albedo.png"),
                 generateSampleAlbedo(name, sample.size, sample.size), StorageFormat::U8);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: relievo-samples FOLDER\n");
        return 2;
    }
    try {
        for (const BundledSample& sample : kBundledSamples)
            writeSample(argv[1], sample);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "relievo-samples: %s\n", error.what());
        return 1;
    }
    return 0;
}
