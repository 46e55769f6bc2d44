#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace relievo::textures {

/// An output file that appears whole or not at all: the work goes to a temporary file in the same
/// folder, which replaces the target on commit(). An object that dies uncommitted leaves nothing.
class AtomicFile {
  public:
    /// Creates the temporary file, so that a folder which cannot be written is found out before the
    /// work that fills the file. Throws InputError when it cannot be created, and when `target`
    /// exists but is no regular file (renaming would replace a device or a folder).
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// The temporary file, empty at first, for code that writes by name. It ends like the target,
    /// because image libraries choose the format by it.
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

    /// Puts `bytes` at `offset` ≥ 0 from the start of the file. Throws InputError with the system's
    /// reason, such as a full disk.
    void writeAt(std::int64_t offset, std::span<const std::byte> bytes);

    /// Flushes the temporary file to the disk and renames it to the target. Throws InputError with
    /// the system's reason.
    void commit();

  private:
    void discard() noexcept;

    std::filesystem::path target_;
    std::filesystem::path path_;
    int slot_ = -1;
    int descriptor_ = -1;
};

/// Removes the temporary files of all live AtomicFile objects of the process. Async-signal-safe:
/// for handlers of SIGINT and SIGTERM that end the process right after.
void removeTemporaryFiles() noexcept;

}  // namespace relievo::textures
