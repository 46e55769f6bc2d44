#include "bench/allocated_memory.h"

#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <thread>
#include <vector>

namespace relievo::bench {
namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

// Allocators round up, by a page at most.
void expectAbout(std::size_t bytes, std::size_t expected) {
    EXPECT_GE(bytes, expected);
    EXPECT_LE(bytes, expected + 8192);
}

TEST(AllocatedMemory, CountsContainersFromAnyThreadUntilTheyAreGone) {
    const std::size_t before = allocatedBytes();
    {
        const std::vector<char> one(kMegabyte);
        std::vector<char> two;
        std::thread([&] { two.resize(2 * kMegabyte); }).join();
        expectAbout(allocatedBytes() - before, 3 * kMegabyte);
    }
    EXPECT_EQ(allocatedBytes(), before);
}

TEST(AllocatedMemory, RemembersTheMostUntilItIsForgotten) {
    forgetMostAllocatedBytes();
    const std::size_t before = allocatedBytes();
    std::make_unique<std::vector<char>>(5 * kMegabyte);
    EXPECT_EQ(allocatedBytes(), before);
    expectAbout(mostAllocatedBytes() - before, 5 * kMegabyte);
    forgetMostAllocatedBytes();
    EXPECT_EQ(mostAllocatedBytes(), before);
}

TEST(AllocatedMemory, HasBlocksWithAlignmentOfTheirOwn) {
    struct alignas(256) Block {
        char bytes[kMegabyte];
    };
    const std::size_t before = allocatedBytes();
    auto block = std::make_unique<Block>();
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.get()) % 256, 0u);
    expectAbout(allocatedBytes() - before, kMegabyte);
    block.reset();
    EXPECT_EQ(allocatedBytes(), before);
}

TEST(AllocatedMemory, IsNotCountedWhenThereIsNone) {
    const std::size_t before = allocatedBytes();
    EXPECT_THROW(::operator delete(::operator new (~std::size_t{0} / 4)), std::bad_alloc);
    EXPECT_EQ(::operator new (~std::size_t{0} / 4, std::nothrow), nullptr);
    EXPECT_EQ(allocatedBytes(), before);
}

}  // namespace
}  // namespace relievo::bench
