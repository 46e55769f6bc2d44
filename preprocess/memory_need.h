#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "preprocess/relief_plan.h"

namespace relievo::preprocess {

/// The most memory in bytes that reading a height image of width × height texels, baking it to
/// `plan` (which must have no problem) and writing the file take at one time, the program itself
/// included.
std::uint64_t memoryNeed(const ReliefPlan& plan, int width, int height);

/// What of it each texel takes.
double memoryPerTexel(const ReliefPlan& plan);

/// The bytes of memory that this process may still take: what the system says is available, or less
/// where a control group (a container, a batch job) has a limit. The largest number when the system
/// does not tell. `root` stands in for the folder that holds /proc and /sys.
std::uint64_t availableMemory(const std::filesystem::path& root = "/");

/// Throws textures::InputError with both amounts, beginning with `file`, when baking it would take
/// more than `available` bytes.
void requireMemory(const std::string& file, const ReliefPlan& plan, int width, int height,
                   std::uint64_t available);

/// "640 MB", "2.5 GB": an amount as a person reads it, in powers of 1000.
std::string memoryText(double bytes);

}  // namespace relievo::preprocess
