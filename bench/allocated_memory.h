#pragma once

#include <cstddef>

namespace relievo::bench {

/// The memory that this program has from operator new, all containers included: programs that call
/// these functions count it. Bytes as the allocator rounds them up. What libraries written in C and
/// the stacks of threads take is not in it.
std::size_t allocatedBytes() noexcept;

/// The most that it was at any time since the last call of forgetMostAllocatedBytes, or since the
/// start of the program.
std::size_t mostAllocatedBytes() noexcept;

/// Lets the most begin anew at what is allocated now.
void forgetMostAllocatedBytes() noexcept;

}  // namespace relievo::bench
