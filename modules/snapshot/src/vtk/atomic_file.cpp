#include "atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::snapshot {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error_number) {
  const bool full = error_number == ENOSPC || error_number == EDQUOT;
  const char* cure = full ? "free space or choose another output directory"
                          : "check the path and its permissions or choose another output directory";
  throw Error(fmt::format("{}: cannot be written ({}); {}", file.string(), std::strerror(error_number), cure),
              full ? ExitStatus::failure : ExitStatus::bad_input);
}

void create_directories_of(const std::filesystem::path& file) {
  if (!file.has_parent_path()) return;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error) fail(file, error.value());
}

// Returns 0, or the error number of the first failed call.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(std::size_t(written));
  }
  return 0;
}

}  // namespace

void write_atomically(const std::filesystem::path& file, std::string_view bytes) {
  create_directories_of(file);
  const std::string temporary =
      (file.parent_path() / fmt::format(".{}.{}.part", file.filename().string(), ::getpid())).string();
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(file, errno);
  int error_number = write_all(descriptor, bytes);
  if (::close(descriptor) != 0 && error_number == 0) error_number = errno;
  if (error_number == 0 && std::rename(temporary.c_str(), file.c_str()) != 0) error_number = errno;
  if (error_number == 0) return;
  ::unlink(temporary.c_str());
  fail(file, error_number);
}

}  // namespace scree::snapshot
