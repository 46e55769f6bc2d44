#include "textures/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "textures/input_error.h"

namespace relievo::textures {

namespace {

/// The names of the live temporary files, where a signal handler can read them: a fixed table,
/// because a handler may neither allocate nor lock. A slot is claimed first and filled before it is
/// marked live, so that the handler never sees half a name.
struct TemporaryName {
    std::atomic<bool> claimed{false};
    std::atomic<bool> live{false};
    std::array<char, 4096> path{};
};
static_assert(std::atomic<bool>::is_always_lock_free);

std::array<TemporaryName, 64> temporaryNames;

int registerTemporaryName(const std::string& path) {
    for (std::size_t slot = 0; slot < temporaryNames.size(); ++slot) {
        TemporaryName& name = temporaryNames[slot];
        if (path.size() >= name.path.size() || name.claimed.exchange(true))
            continue;
        std::copy(path.begin(), path.end(), name.path.begin());
        name.path[path.size()] = '\0';
        name.live = true;
        return static_cast<int>(slot);
    }
    return -1;
}

void releaseTemporaryName(int slot) noexcept {
    TemporaryName& name = temporaryNames[static_cast<std::size_t>(slot)];
    name.live = false;
    name.claimed = false;
}

[[noreturn]] void failToWrite(const std::filesystem::path& target, const std::string& reason) {
    throw InputError(fmt::format("{}: cannot be written: {}", target.string(), reason));
}

[[noreturn]] void failToWrite(const std::filesystem::path& target, int error) {
    failToWrite(target, std::generic_category().message(error));
}

/// Short and in the same folder; the number keeps several outputs of one process apart.
std::filesystem::path temporaryPath(const std::filesystem::path& target) {
    static std::atomic<unsigned> count{0};
    return target.parent_path() /
           fmt::format(".relievo-{}-{}{}", ::getpid(), count++, target.extension().string());
}

/// The new name of a file lives in its folder, which has a write-back of its own. Failure is
/// ignored: some file systems cannot do it, and the file itself is safe by then.
void flushFolder(const std::filesystem::path& target) noexcept {
    const std::filesystem::path folder = target.parent_path();
    const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target)
    : target_(std::move(target)), path_(temporaryPath(target_)) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(target_, ignored);
    if (target_.filename().empty() || std::filesystem::is_directory(status))
        failToWrite(target_, "it is a folder, expected the name of a file");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        failToWrite(target_, "it exists and is no regular file");
    slot_ = registerTemporaryName(path_.string());
    if (slot_ < 0)
        failToWrite(target_, "too many files are being written, or its path is too long");
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
        const int error = errno;
        releaseTemporaryName(slot_);
        slot_ = -1;
        failToWrite(target_, error);
    }
}

AtomicFile::~AtomicFile() {
    discard();
}

void AtomicFile::writeAt(std::int64_t offset, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), offset);
        if (written >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(written));
            offset += written;
        } else if (errno != EINTR) {
            failToWrite(target_, errno);
        }
    }
}

void AtomicFile::commit() {
    if (::fsync(descriptor_) != 0)
        failToWrite(target_, errno);
    if (::close(std::exchange(descriptor_, -1)) != 0)
        failToWrite(target_, errno);
    if (::rename(path_.c_str(), target_.c_str()) != 0)
        failToWrite(target_, errno);
    releaseTemporaryName(std::exchange(slot_, -1));
    flushFolder(target_);
}

void AtomicFile::discard() noexcept {
    if (descriptor_ >= 0)
        ::close(std::exchange(descriptor_, -1));
    if (slot_ >= 0) {
        ::unlink(path_.c_str());
        releaseTemporaryName(std::exchange(slot_, -1));
    }
}

void removeTemporaryFiles() noexcept {
    for (const TemporaryName& name : temporaryNames)
        if (name.live)
            ::unlink(name.path.data());
}

}  // namespace relievo::textures
