#pragma once

#include <cstddef>
#include <vector>

namespace relievo::textures {

/// Makes room for `count` values in an empty vector. Many of them get memory in large pages where
/// the system has such (Linux): to get 16 MiB in pages of 4 KiB takes longer than to fill them.
void reserveLargePages(std::vector<float>& values, std::size_t count);

}  // namespace relievo::textures
