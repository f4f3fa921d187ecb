#include "frame_transfer.hpp"

#include "vtp_reader.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::pictures {
namespace {

// Both have raw(), so that one function writes and reads a frame.
struct Packer {
  std::string bytes;
  void raw(void* from, std::size_t count) { bytes.append(static_cast<const char*>(from), count); }
  void require(std::size_t) {}
};
struct Unpacker {
  std::string_view bytes;
  void raw(void* to, std::size_t count) {
    require(count);
    if (count > 0) std::memcpy(to, bytes.data(), count);
    bytes.remove_prefix(count);
  }
  void require(std::size_t count) const {
    if (count > bytes.size()) throw std::length_error("a frame ends early");
  }
};

template <class Packing, class Values>
void transfer_column(Packing& packing, Values& values) {
  std::size_t size = values.size();
  packing.raw(&size, sizeof(size));
  packing.require(size);
  values.resize(size);
  packing.raw(values.data(), size * sizeof(values[0]));
}

template <class Packing>
void transfer(Packing& packing, Frame& f) {
  packing.raw(&f.time, sizeof(f.time));
  packing.raw(&f.step, sizeof(f.step));
  packing.raw(&f.dimension, sizeof(f.dimension));
  packing.raw(&f.lower, sizeof(f.lower));
  packing.raw(&f.upper, sizeof(f.upper));
  const auto columns = [&](auto&... column) { (transfer_column(packing, column), ...); };
  columns(f.title, f.id, f.radius, f.position, f.material, f.coordination, f.velocity, f.spin, f.force,
          f.contact_from, f.contact_to, f.contact_normal_force, f.contact_tangential_force, f.contact_overlap,
          f.contact_sliding);
  std::size_t walls = f.walls.size();
  packing.raw(&walls, sizeof(walls));
  packing.require(walls);
  f.walls.resize(walls);
  for (Wall& wall : f.walls) {
    transfer_column(packing, wall.name);
    packing.raw(&wall.point, sizeof(wall.point));
    packing.raw(&wall.normal, sizeof(wall.normal));
  }
}

void limit(int resource, rlim_t most) {
  rlimit now = {};
  getrlimit(__rlimit_resource_t(resource), &now);
  now.rlim_cur = std::min(most, now.rlim_max);
  setrlimit(__rlimit_resource_t(resource), &now);
}

// Memory (bytes) that the process has already allocated.
[[maybe_unused]] rlim_t allocated() {
  std::ifstream file("/proc/self/statm");
  rlim_t total = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
  file >> total >> resident >> shared >> text >> library >> data;
  return file ? data * rlim_t(sysconf(_SC_PAGESIZE)) : 0;
}

// Ten times what files that a run has written need.
void limit_resources(std::uintmax_t file_size) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, 4 + file_size / 1'000'000);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  limit(RLIMIT_DATA, allocated() + (rlim_t(2) << 30) + 200 * file_size);
#endif
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(std::size_t(written));
  }
  return true;
}

std::string read_all(int descriptor) {
  std::string bytes;
  char block[1 << 16];
  for (;;) {
    const ssize_t count = read(descriptor, block, sizeof(block));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(block, std::size_t(count));
  }
}

// Exit statuses that no library uses when it gives up.
enum ChildStatus { sent_frame = 101, sent_refusal = 102, failed_to_send = 103 };

[[noreturn]] void run_child(const std::filesystem::path& file, int output) {
  for (const int number : {SIGINT, SIGTERM, SIGSEGV, SIGABRT, SIGBUS, SIGFPE}) std::signal(number, SIG_DFL);
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(file, failed);
  limit_resources(failed ? 0 : size);
  try {
    Frame frame = read_vtp(file);
    Packer packer;
    transfer(packer, frame);
    _exit(write_all(output, packer.bytes) ? sent_frame : failed_to_send);
  } catch (const Error& error) {
    _exit(write_all(output, error.what()) ? sent_refusal : failed_to_send);
  } catch (...) {
    _exit(failed_to_send);
  }
}

Error damaged(const std::filesystem::path& file) {
  return Error(
      fmt::format("{}: is damaged; give a particles_<step>.vtp file that a run has written, with its "
                  "contacts file as it was",
                  file.string()));
}

}  // namespace

Frame read_vtp_apart(const std::filesystem::path& file) {
  int ends[2];
  if (pipe(ends) != 0)
    throw Error(
        fmt::format("{}: cannot be read ({}); close other files", file.string(), std::strerror(errno)),
        ExitStatus::failure);
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    run_child(file, ends[1]);
  }
  close(ends[1]);
  const std::string bytes = child > 0 ? read_all(ends[0]) : "";
  close(ends[0]);
  int status = -1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (child < 0)
    throw Error(fmt::format("{}: cannot be read (no process can be started); end others", file.string()),
                ExitStatus::failure);
  if (WIFEXITED(status) && WEXITSTATUS(status) == sent_refusal) throw Error(bytes);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != sent_frame) throw damaged(file);
  try {
    Frame frame;
    Unpacker unpacker{bytes};
    transfer(unpacker, frame);
    return frame;
  } catch (const std::length_error&) {
    throw damaged(file);
  }
}

}  // namespace scree::pictures
