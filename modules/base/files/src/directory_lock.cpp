#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/files/directory_lock.hpp>
#include <scree/files/place_error.hpp>

namespace scree::files {

namespace fs = std::filesystem;

namespace {

PlaceError unusable(const fs::path& path, const char* what, int code) {
  return {path.string(), fmt::format("cannot be {} ({})", what, std::strerror(code)), ""};
}

fs::path lock_in(const fs::path& directory) { return directory / DirectoryLock::file_name; }

}  // namespace

int DirectoryLock::make_directories(bool must_be_new) {
  std::vector<fs::path> missing;
  std::error_code failed;
  for (fs::path p = directory_; !fs::exists(p, failed) && p != p.parent_path(); p = p.parent_path())
    missing.push_back(p);
  if (missing.empty()) return must_be_new ? EEXIST : 0;
  for (auto p = missing.rbegin(); p != missing.rend(); ++p)
    if (mkdir(p->c_str(), 0777) == 0)
      made_.push_back(*p);
    else if (errno != EEXIST || (must_be_new && *p == directory_))
      return errno;
  return 0;
}

bool DirectoryLock::is_current() const { return is_at(file_, lock_in(directory_).c_str()); }

fs::path DirectoryLock::moved_to() const {
  std::error_code failed;
  const fs::path lock = fs::read_symlink(fmt::format("/proc/self/fd/{}", file_.get()), failed);
  return !failed && is_at(file_, lock.c_str()) ? lock.parent_path() : fs::path();
}

DirectoryLock::Attempt DirectoryLock::attempt(Children children, bool must_be_new) {
  const int code = make_directories(must_be_new);
  if (must_be_new && code == EEXIST) return Attempt::refused;
  // Another process may just have removed what it had made.
  if (code == ENOENT) return Attempt::removed;
  if (code) throw unusable(directory_, "created", code);
  const int closing = children == Children::none ? O_CLOEXEC : 0;
  Descriptor file(open(lock_in(directory_).c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | closing, 0666));
  if (!file.is_open() && errno == ENOENT) return Attempt::removed;
  if (!file.is_open()) throw unusable(lock_in(directory_), "written", errno);
  excludes_ = flock(file.get(), LOCK_EX | LOCK_NB) == 0;
  if (!excludes_ && errno == EWOULDBLOCK) return Attempt::refused;
  file_ = std::move(file);
  if (is_current()) return Attempt::taken;
  file_ = Descriptor();
  return Attempt::removed;
}

std::optional<DirectoryLock> DirectoryLock::take(const fs::path& directory, Children children,
                                                 bool must_be_new) {
  constexpr int max_attempts = 100;
  for (int k = 0; k < max_attempts; ++k) {
    DirectoryLock lock(fs::absolute(directory).lexically_normal());
    const Attempt result = lock.attempt(children, must_be_new);
    if (result == Attempt::taken) return lock;
    if (result == Attempt::refused) return std::nullopt;
  }
  throw unusable(directory, "created", ENOENT);
}

std::optional<DirectoryLock> DirectoryLock::take(const fs::path& directory, Children children) {
  return take(directory, children, false);
}

std::optional<DirectoryLock> DirectoryLock::take_new(const fs::path& directory) {
  return take(directory, Children::none, true);
}

bool DirectoryLock::is_held(const fs::path& directory) {
  const Descriptor file(open(lock_in(directory).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  return file.is_open() && flock(file.get(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

DirectoryLock::~DirectoryLock() {
  // Removed before it is closed: whoever has opened it meanwhile finds that it is no longer current.
  if (file_.is_open() && is_current()) unlink(lock_in(directory_).c_str());
  for (auto p = made_.rbegin(); p != made_.rend(); ++p) rmdir(p->c_str());
}

}  // namespace scree::files
