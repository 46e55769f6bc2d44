#include "preprocess/memory_need.h"

#include <gmock/gmock.h>

#include <fstream>
#include <limits>

#include "tests/textures/temporary_folder.h"

namespace relievo::preprocess {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class AvailableMemory : public textures::TemporaryFolder {
  protected:
    void write(const std::string& name, const std::string& text) {
        std::filesystem::create_directories(file(name).parent_path());
        std::ofstream(file(name)) << text;
    }
    void SetUp() override {
        TemporaryFolder::SetUp();
        write("proc/meminfo", "MemTotal: 900 kB\nMemFree: 100 kB\nMemAvailable:  500 kB\n");
    }
    [[nodiscard]] std::uint64_t available() const { return availableMemory(folder()); }
};

TEST_F(AvailableMemory, IsWhatTheSystemSays) {
    EXPECT_EQ(available(), 500u * 1024);
    std::filesystem::remove(file("proc/meminfo"));
    EXPECT_EQ(available(), std::numeric_limits<std::uint64_t>::max());
    EXPECT_GT(availableMemory(), 0u);
}

TEST_F(AvailableMemory, GroupsHaveLimitsOfTheirOwn) {
    write("proc/self/cgroup", "0::/jobs/this\n");
    write("sys/fs/cgroup/jobs/this/memory.max", "max\n");
    write("sys/fs/cgroup/jobs/this/memory.current", "70000\n");
    EXPECT_EQ(available(), 500u * 1024) << "no limit here";
    write("sys/fs/cgroup/jobs/memory.max", "100000\n");
    write("sys/fs/cgroup/jobs/memory.current", "80000\n");
    EXPECT_EQ(available(), 20000u) << "the group around it";
    write("sys/fs/cgroup/jobs/memory.stat", "anon 1\nactive_file 900\ninactive_file 30000\n");
    EXPECT_EQ(available(), 50000u) << "files in memory give way";
    write("sys/fs/cgroup/jobs/memory.current", "200000\n");
    EXPECT_EQ(available(), 0u);
}

TEST_F(AvailableMemory, GroupsOfTheFirstVersion) {
    write("proc/self/cgroup", "3:cpu:/a\n2:memory:/outside/a\n");
    write("sys/fs/cgroup/memory/memory.limit_in_bytes", "5000\n");
    write("sys/fs/cgroup/memory/memory.usage_in_bytes", "1000\n");
    EXPECT_EQ(available(), 4000u);
}

TEST(MemoryNeed, GrowsWithTheMapsAndTheirSize) {
    ReliefPlan few;
    few.maps = {"depth"};
    ReliefPlan many;
    many.maps = {"depth", "derivative", "normal", "cone"};
    EXPECT_LT(memoryNeed(few, 1000, 1000), memoryNeed(many, 1000, 1000));
    EXPECT_GT(memoryPerTexel(many), 4.0 * 7);
    EXPECT_NEAR(static_cast<double>(memoryNeed(many, 4096, 4096) - memoryNeed(many, 4096, 2048)),
                memoryPerTexel(many) * 4096 * 2048, 2);
}

TEST(MemoryNeed, CountsEverySliceOfAVolume) {
    ReliefPlan few;
    few.maps = {"volume"};
    ReliefPlan many = few;
    many.slices = few.slices + 100;
    EXPECT_DOUBLE_EQ(memoryPerTexel(many), memoryPerTexel(few) + 400.0);
}

TEST(MemoryNeed, CountsTheTableOfDisplacementsBesideItsFactors) {
    ReliefPlan table;
    table.maps = {"vdm"};
    table.terms = 0;
    ReliefPlan packed = table;
    packed.terms = 8;
    const double factors = 8.0 * 16.0 + 16.0 * 2.0;  // 16 azimuths, 2 curvatures above 0
    EXPECT_DOUBLE_EQ(memoryPerTexel(packed), memoryPerTexel(table) + 4.0 * factors);
    EXPECT_GT(memoryPerTexel(table), 4.0 * 640.0);
}

TEST(MemoryNeed, MoreThanThereIsIsRefusedWithBothAmounts) {
    const ReliefPlan plan;
    const std::uint64_t need = memoryNeed(plan, 4096, 4096);
    EXPECT_NO_THROW(requireMemory("a.png", plan, 4096, 4096, need));
    EXPECT_THAT(textures::errorOf([&] { requireMemory("a.png", plan, 4096, 4096, 123456789); }),
                AllOf(HasSubstr("a.png: its maps of 4096 x 4096 texels take "),
                      HasSubstr(memoryText(static_cast<double>(need)) + " of memory"),
                      HasSubstr("but 123 MB are available")));
}

}  // namespace
}  // namespace relievo::preprocess
