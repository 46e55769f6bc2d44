// The inputs that the fuzzers start from, and those that once broke something.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>

#include "tests/fuzz/fuzz_targets.h"

namespace relievo::textures {
namespace {

template <class Target>
void runCorpus(const char* name, Target target) {
    int count = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(RELIEVO_FUZZ_CORPUS) / name)) {
        SCOPED_TRACE(entry.path());
        std::ifstream stream(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        target(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
        ++count;
    }
    EXPECT_GT(count, 2);
}

TEST(FuzzCorpus, MapFiles) {
    runCorpus("map_file", fuzzMapFile);
}

TEST(FuzzCorpus, Metadata) {
    runCorpus("metadata", fuzzMetadata);
}

}  // namespace
}  // namespace relievo::textures
