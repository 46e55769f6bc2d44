#include "textures/atomic_file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "temporary_folder.h"
#include "textures/map_file.h"

namespace relievo::textures {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::span<const std::byte> bytesOf(const std::string& text) {
    return std::as_bytes(std::span(text));
}

/// No file of this process may grow beyond `bytes` while it lives: the nearest thing to a full disk
/// that needs no rights.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int);
};

class AtomicFileTest : public TemporaryFolder {};

TEST_F(AtomicFileTest, AppearsOnCommitOnly) {
    AtomicFile output(file("a.exr"));
    output.writeAt(7, bytesOf("second"));
    output.writeAt(0, bytesOf("first, "));
    EXPECT_FALSE(std::filesystem::exists(file("a.exr")));
    EXPECT_EQ(output.path().parent_path(), folder()) << "a rename must not cross file systems";
    EXPECT_EQ(output.path().extension(), ".exr") << "libraries choose the format by it";
    output.commit();
    EXPECT_EQ(readBytes(file("a.exr")), "first, second");
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(AtomicFileTest, ReplacesWhatWasThereAtOnce) {
    writeBytes(file("a.txt"), "old");
    AtomicFile output(file("a.txt"));
    output.writeAt(0, bytesOf("new"));
    EXPECT_EQ(readBytes(file("a.txt")), "old");
    output.commit();
    EXPECT_EQ(readBytes(file("a.txt")), "new");
}

TEST_F(AtomicFileTest, LeavesNothingWithoutCommit) {
    writeBytes(file("a.txt"), "old");
    {
        AtomicFile output(file("a.txt"));
        output.writeAt(0, bytesOf("half of the n"));
        EXPECT_EQ(fileCount(), 2);
    }
    EXPECT_EQ(fileCount(), 1);
    EXPECT_EQ(readBytes(file("a.txt")), "old");
}

TEST_F(AtomicFileTest, TakesWhatOthersWriteByName) {
    AtomicFile output(file("a.txt"));
    writeBytes(output.path(), "by name");
    output.commit();
    EXPECT_EQ(readBytes(file("a.txt")), "by name");
}

TEST_F(AtomicFileTest, SaysWhyItCannotBeWritten) {
    const auto complaint = [&](const std::filesystem::path& path) {
        const std::string message = errorOf([&] { AtomicFile{path}; });
        EXPECT_THAT(message, StartsWith(path.string() + ": cannot be written: "));
        return message;
    };
    EXPECT_THAT(complaint(file("none/a.png")), HasSubstr("No such file or directory"));
    writeBytes(file("b"), "");
    EXPECT_THAT(complaint(file("b/a.png")), HasSubstr("Not a directory"));
    EXPECT_THAT(complaint(folder()), HasSubstr("it is a folder"));
    EXPECT_THAT(complaint("/dev/null"), HasSubstr("no regular file"));
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(AtomicFileTest, AFullDiskLeavesNothing) {
    const FileSizeLimit limit(1000);
    const std::string message = errorOf([&] {
        AtomicFile output(file("a.txt"));
        output.writeAt(0, bytesOf(std::string(2000, 'x')));
        output.commit();
    });
    EXPECT_THAT(message, HasSubstr("a.txt: cannot be written: File too large"));
    EXPECT_EQ(fileCount(), 0);
}

TEST_F(AtomicFileTest, AMapFileOnAFullDiskLeavesNothing) {
    MapSet maps;
    maps.channels = {{"depth", Plane(64, 64, 0.5f)}};
    for (const auto& [name, format] : {std::pair{"a.exr", StorageFormat::Float},
                                       {"a.png", StorageFormat::U16},
                                       {"a.tif", StorageFormat::U8}}) {
        const FileSizeLimit limit(100);
        EXPECT_THAT(errorOf([&] { writeMapFile(file(name), maps, format); }),
                    HasSubstr("cannot be written: File too large"));
        EXPECT_EQ(fileCount(), 0);
    }
}

TEST_F(AtomicFileTest, TheSignalHandlerRemovesLiveFilesOnly) {
    auto first = std::make_unique<AtomicFile>(file("a.txt"));
    const AtomicFile second(file("b.txt"));
    first->commit();
    EXPECT_EQ(fileCount(), 2);
    removeTemporaryFiles();
    EXPECT_EQ(fileCount(), 1);
    EXPECT_TRUE(std::filesystem::exists(file("a.txt")));
}

TEST_F(AtomicFileTest, SlotsAreUsedAgain) {
    for (int n = 0; n < 500; ++n)
        AtomicFile{file("a.txt")};
    AtomicFile(file("a.txt")).commit();
    std::vector<std::unique_ptr<AtomicFile>> many;
    EXPECT_THAT(errorOf([&] {
                    for (int n = 0; n < 500; ++n)
                        many.push_back(std::make_unique<AtomicFile>(file("b.txt")));
                }),
                HasSubstr("too many files"));
    many.clear();
    EXPECT_EQ(fileCount(), 1);
}

}  // namespace
}  // namespace relievo::textures
