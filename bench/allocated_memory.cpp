// Replaces operator new and delete of the whole program. That counts every byte that a builder
// takes, whatever the allocator keeps for later or hands back; the peak resident size of a process
// has in it what ran before and does not show memory that is not touched.
#include "bench/allocated_memory.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace relievo::bench {
namespace {

std::atomic<std::size_t> allocated{0};
std::atomic<std::size_t> most{0};

void* counted(void* block) noexcept {
    if (block != nullptr) {
        const std::size_t bytes = ::malloc_usable_size(block);
        const std::size_t now = allocated.fetch_add(bytes, std::memory_order_relaxed) + bytes;
        std::size_t before = most.load(std::memory_order_relaxed);
        while (now > before && !most.compare_exchange_weak(before, now, std::memory_order_relaxed))
            ;
    }
    return block;
}

}  // namespace

std::size_t allocatedBytes() noexcept {
    return allocated.load(std::memory_order_relaxed);
}

std::size_t mostAllocatedBytes() noexcept {
    return most.load(std::memory_order_relaxed);
}

void forgetMostAllocatedBytes() noexcept {
    most.store(allocatedBytes(), std::memory_order_relaxed);
}

namespace {

void* allocate(std::size_t bytes) {
    void* const block = counted(std::malloc(bytes > 0 ? bytes : 1));
    if (block == nullptr)
        throw std::bad_alloc();
    return block;
}

void* allocate(std::size_t bytes, std::align_val_t alignment) {
    const auto boundary = static_cast<std::size_t>(alignment);
    // aligned_alloc takes multiples of the alignment only.
    const std::size_t rounded = (bytes + boundary - 1) / boundary * boundary;
    void* const block = counted(std::aligned_alloc(boundary, rounded > 0 ? rounded : boundary));
    if (block == nullptr)
        throw std::bad_alloc();
    return block;
}

void release(void* block) noexcept {
    if (block != nullptr)
        allocated.fetch_sub(::malloc_usable_size(block), std::memory_order_relaxed);
    std::free(block);
}

}  // namespace
}  // namespace relievo::bench

// The forms for arrays, and those that do not throw, call these.
void* operator new(std::size_t bytes) {
    return relievo::bench::allocate(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return relievo::bench::allocate(bytes, alignment);
}
void operator delete(void* block) noexcept {
    relievo::bench::release(block);
}
void operator delete(void* block, std::size_t) noexcept {
    relievo::bench::release(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
    relievo::bench::release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    relievo::bench::release(block);
}
