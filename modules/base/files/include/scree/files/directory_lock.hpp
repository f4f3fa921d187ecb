#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <scree/files/descriptor.hpp>

namespace scree::files {

// The right to write into a directory, which one process has at a time: until this object is destroyed, or
// until the process ends in any way. Directories that were made for it are removed with it if they are empty
// then.
class DirectoryLock {
 public:
  // In the directory while it is locked, and after a process that was killed.
  static constexpr const char* file_name = ".lock";
  // inherited: processes started by this one hold the lock too, until the last of them ends.
  enum class Children { none, inherit };

  // Makes the directory, with its parents, if it is not there, and locks it. Absent: another process has it.
  // Throws Error "path: what is wrong; what to do". Where a file system has no locks, two processes can have
  // one: see excludes().
  static std::optional<DirectoryLock> take(const std::filesystem::path& directory,
                                           Children children = Children::none);
  // The same, but absent also if something has this name already.
  static std::optional<DirectoryLock> take_new(const std::filesystem::path& directory);

  // Whether a process, also this one, has the directory.
  static bool is_held(const std::filesystem::path& directory);

  // Whether other processes are kept out: false on a file system without locks.
  bool excludes() const { return excludes_; }
  // Whether the lock file in the directory is still the open one: false once it or the directory was removed
  // or moved.
  bool is_current() const;
  // Where a directory that is no longer current is now; empty if it was removed or cannot be found.
  std::filesystem::path moved_to() const;

  DirectoryLock(DirectoryLock&&) = default;
  DirectoryLock& operator=(DirectoryLock&&) = delete;
  ~DirectoryLock();

 private:
  enum class Attempt { taken, refused, removed };
  explicit DirectoryLock(std::filesystem::path directory) : directory_(std::move(directory)) {}
  static std::optional<DirectoryLock> take(const std::filesystem::path& directory, Children children,
                                           bool must_be_new);
  Attempt attempt(Children children, bool must_be_new);
  // Returns 0, or the value of errno.
  int make_directories(bool must_be_new);

  std::filesystem::path directory_;          // absolute
  std::vector<std::filesystem::path> made_;  // from the top down
  Descriptor file_;
  bool excludes_ = true;
};

}  // namespace scree::files
