#include "opened_file.hpp"

#include "backend.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/available_memory.hpp>
#include <scree/error.hpp>

namespace scree::state_file {
namespace {

// A pipe is not waited for, and not read.
int open_regular(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  const char* reason = std::strerror(errno);
  if (descriptor < 0 && errno == ENOENT)
    throw Error(fmt::format("{}: there is no such file; check the path", path.string()));
  if (descriptor < 0)
    throw Error(fmt::format("{}: cannot be opened ({}); check its permissions", path.string(), reason));
  struct stat status = {};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) return descriptor;
  ::close(descriptor);
  throw Error(fmt::format("{}: is not a regular file; give a state file", path.string()));
}

}  // namespace

OpenedFile::OpenedFile(std::filesystem::path path)
    : path_(std::move(path)), descriptor_(open_regular(path_)) {
  try {
    seal_ = checked_seal(descriptor_, path_);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

OpenedFile::~OpenedFile() { ::close(descriptor_); }

State OpenedFile::state() const {
  StateBackend& backend = load_backend();
  try {
    return backend.read(name_of(descriptor_), available_memory());
  } catch (const Error& error) {
    throw Error(
        fmt::format("{}: {}; write it anew with this version of scree", path_.string(), error.what()));
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: does not fit into memory; use a computer with more", path_.string()));
  }
}

std::filesystem::path name_of(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

}  // namespace scree::state_file
