#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include <scree/files/descriptor.hpp>

namespace scree::files {

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

int Descriptor::release() { return std::exchange(number_, -1); }

Descriptor create_file(const char* path) {
  unlink(path);
  return Descriptor(open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
}

Descriptor append_file(const char* path) {
  return Descriptor(open(path, O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666));
}

bool is_at(const Descriptor& file, const char* path) {
  struct stat open {
  }, named{};
  return fstat(file.get(), &open) == 0 && lstat(path, &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

int write_all(const Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(std::size_t(written));
  }
  return 0;
}

}  // namespace scree::files
