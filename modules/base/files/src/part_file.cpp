#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/part_file.hpp>
#include <scree/files/text_file.hpp>

namespace scree::files {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int code) {
  const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG || code == EIO;
  const char* cure = full             ? "check the space on the disk"
                     : code == EISDIR ? "move it elsewhere"
                                      : "check that its folder exists and is writable";
  throw Error(path.string(), fmt::format("cannot be written ({})", std::strerror(code)), cure,
              ExitStatus::failure);
}

// The new name is on the disk only with its folder. Some file systems cannot do this for a folder.
bool is_folder_on_disk(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return errno == EACCES;  // a folder that may be written to but not read
  const bool done = ::fsync(descriptor) == 0 || errno == EINVAL;
  const int code = errno;
  ::close(descriptor);
  errno = code;
  return done;
}

}  // namespace

PartFile::PartFile(std::filesystem::path path) : path_(std::move(path)), temporary_(path_) {
  temporary_ += part_suffix;
  if (::unlink(temporary_.c_str()) != 0 && errno != ENOENT) fail(errno == EISDIR ? temporary_ : path_, errno);
  descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path_, errno);
}

PartFile::~PartFile() {
  if (!committed_) ::unlink(temporary_.c_str());
  ::close(descriptor_);
}

void PartFile::commit() {
  if (::fsync(descriptor_) != 0) fail(path_, errno);
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, errno);
  committed_ = true;
  if (!is_folder_on_disk(path_)) fail(path_, errno);
}

}  // namespace scree::files
