#include "preprocess/memory_need.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

#include "preprocess/map_kinds.h"
#include "textures/input_error.h"

namespace relievo::preprocess {
namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
constexpr double kPlaneBytes = sizeof(float);
// Red, green and blue, and the luminance that is made of them.
constexpr double kReadingBytes = 4 * kPlaneBytes;
// The libraries with their tables, and some rows of the file at a time.
constexpr double kProgramBytes = 150e6;
constexpr double kRowBuffers = 256;

// The number behind `key` in a file of lines such as "MemAvailable:  123 kB".
std::optional<std::uint64_t> numberIn(const std::filesystem::path& file, std::string_view key) {
    std::ifstream stream(file);
    for (std::string word; stream >> word;)
        if (word == key) {
            std::uint64_t number = 0;
            if (stream >> number)
                return number;
        }
    return std::nullopt;
}

std::optional<std::uint64_t> firstNumberIn(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::uint64_t number = 0;
    return stream >> number ? std::optional(number) : std::nullopt;
}

// What a group may still take. The pages of files that it read lately can be had back.
std::uint64_t leftInGroup(const std::filesystem::path& group, const char* limitFile,
                          const char* usageFile) {
    const auto limit = firstNumberIn(group / limitFile);  // "max" is no number
    const auto usage = firstNumberIn(group / usageFile);
    if (!limit || !usage)
        return kNoLimit;
    const std::uint64_t cached = numberIn(group / "memory.stat", "inactive_file").value_or(0);
    const std::uint64_t used = *usage - std::min(cached, *usage);
    return *limit - std::min(used, *limit);
}

// The least over the group of this process and those that it lies in. Lines of /proc/self/cgroup
// are "0::/path" (version 2) and "number:controllers:/path" (version 1). In a container the path
// may be that outside, which is not there; the group is then at the top.
std::uint64_t leftInGroups(const std::filesystem::path& root) {
    std::uint64_t left = kNoLimit;
    std::ifstream stream(root / "proc/self/cgroup");
    for (std::string line; std::getline(stream, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos)
            continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const bool isSecondVersion = controllers.empty();
        if (!isSecondVersion && controllers != "memory")
            continue;
        const std::filesystem::path top =
            root / (isSecondVersion ? "sys/fs/cgroup" : "sys/fs/cgroup/memory");
        std::filesystem::path path = line.substr(second + 1);
        for (path = path.relative_path();; path = path.parent_path()) {
            left = std::min(left, isSecondVersion
                                      ? leftInGroup(top / path, "memory.max", "memory.current")
                                      : leftInGroup(top / path, "memory.limit_in_bytes",
                                                    "memory.usage_in_bytes"));
            if (path.empty())
                break;
        }
    }
    return left;
}

}  // namespace

double memoryPerTexel(const ReliefPlan& plan) {
    // The depths of all MIP levels are there from the start, the maps of the small ones at the end.
    const double levels = plan.mips ? 4.0 / 3.0 : 1.0;
    double peak = kReadingBytes;
    double built = kPlaneBytes;  // the depths, from first to last
    for (const MapKind& kind : mapKinds())
        if (kind.build != nullptr && plan.has(kind.name)) {
            built += kPlaneBytes * static_cast<double>(kind.channels(plan).size());
            peak = std::max(peak, built + kind.workingBytes(plan));
        }
    return peak + built * (levels - 1.0);
}

std::uint64_t memoryNeed(const ReliefPlan& plan, int width, int height) {
    const auto channels = static_cast<double>(channelCount(plan));
    const double rows = kRowBuffers * kPlaneBytes * width * std::max(channels, 4.0);
    return static_cast<std::uint64_t>(kProgramBytes + rows + memoryPerTexel(plan) * width * height);
}

std::uint64_t availableMemory(const std::filesystem::path& root) {
    const auto kilobytes = numberIn(root / "proc/meminfo", "MemAvailable:");
    return std::min(kilobytes ? *kilobytes * 1024 : kNoLimit, leftInGroups(root));
}

void requireMemory(const std::string& file, const ReliefPlan& plan, int width, int height,
                   std::uint64_t available) {
    const std::uint64_t need = memoryNeed(plan, width, height);
    if (need > available)
        throw textures::InputError(fmt::format(
            "{}: its maps of {} x {} texels take {} of memory to bake, but {} are available", file,
            width, height, memoryText(static_cast<double>(need)),
            memoryText(static_cast<double>(available))));
}

std::string memoryText(double bytes) {
    return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6)
                       : fmt::format("{:.1f} GB", bytes / 1e9);
}

}  // namespace relievo::preprocess
