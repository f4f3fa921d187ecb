#include "opened_file.hpp"

#include "array_reader.hpp"
#include "backend.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/available_memory.hpp>
#include <scree/child_process.hpp>
#include <scree/error.hpp>
#include <scree/files/text.hpp>

namespace scree::state_file {
namespace {

// Neither waits for a pipe nor reads one.
int open_regular(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  const char* reason = std::strerror(errno);
  if (descriptor < 0 && errno == ENOENT)
    throw Error(path.string(), "there is no such file", "check the path");
  if (descriptor < 0)
    throw Error(path.string(), fmt::format("cannot be opened ({})", reason), "check its permissions");
  struct stat status = {};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) return descriptor;
  ::close(descriptor);
  throw Error(path.string(), "is not a regular file", "give a state file");
}

// Of the child process that asks HDF5 for the places of arrays.
void limit_memory() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  constexpr rlim_t most = rlim_t(4) << 30;  // (bytes) far above what the places of the arrays of a state take
  rlimit now = {};
  getrlimit(RLIMIT_DATA, &now);
  now.rlim_cur = std::min(now.rlim_cur, most);
  setrlimit(RLIMIT_DATA, &now);
#endif
}

}  // namespace

std::vector<PlacedArray> places_in(int descriptor, StateBackend& backend) {
  const ChildEnd end = in_child(
      [&](const Send& send) {
        limit_memory();
        try {
          send("+" + packed(backend.places(name_of(descriptor))));
        } catch (const Error& error) {
          send(std::string("-") + error.what());
        }
      },
      {.seconds = 30, .silent = true});
  if (end.how == ChildEnd::not_started) return backend.places(name_of(descriptor));
  const bool refused = end.sent.starts_with('-');
  if (end.how != ChildEnd::returned || end.sent.empty())
    throw Error(fmt::format("is damaged, so that HDF5 cannot read it ({})", end.text()));
  if (refused) throw Error(end.sent.substr(1));
  return unpacked(std::string_view(end.sent).substr(1));
}

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

void OpenedFile::refuse(const std::string& problem) const {
  struct stat status = {};
  if (::fstat(descriptor_, &status) == 0 && status.st_nlink == 0)
    throw Error(path_.string(), "was removed while it was read", "give a file that stays");
  throw Error(path_.string(), files::one_line(problem, 300), "write it anew with this version of scree");
}

template <class Work>
auto OpenedFile::refusing(const Work& work) const {
  try {
    return work();
  } catch (const Error& error) {
    refuse(error.what());
  } catch (const std::length_error& error) {
    refuse(fmt::format("is damaged, so that HDF5 cannot read it ({})", error.what()));
  } catch (const std::bad_alloc&) {
    throw Error(path_.string(), "does not fit into memory", "use a computer with more");
  }
}

std::vector<PlacedArray> OpenedFile::places() const {
  StateBackend& backend = load_backend(path_);
  return refusing([&] { return places_in(descriptor_, backend); });
}

State OpenedFile::state(const std::vector<PlacedArray>& places) const {
  return refusing([&] {
    State state;
    ArrayReader reader(descriptor_, seal_.bytes, available_memory());
    for (const PlacedArray& place : places) state.put(place.path, reader.read(place));
    return state;
  });
}

std::filesystem::path name_of(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

}  // namespace scree::state_file
