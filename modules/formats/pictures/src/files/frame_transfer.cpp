#include "frame_transfer.hpp"

#include "vtp.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <sys/resource.h>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/child_process.hpp>
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
void transfer_size(Packing& packing, Values& values) {
  std::size_t size = values.size();
  packing.raw(&size, sizeof(size));
  packing.require(size);
  values.resize(size);
}

template <class Packing, class Values>
void transfer_column(Packing& packing, Values& values) {
  transfer_size(packing, values);
  packing.raw(values.data(), values.size() * sizeof(values[0]));
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
          f.displacement, f.group, f.contact_from, f.contact_to, f.contact_normal_force,
          f.contact_tangential_force, f.contact_overlap, f.contact_sliding, f.contact_a, f.contact_b,
          f.contact_wall, f.contact_normal, f.contact_force, f.contact_point);
  transfer_size(packing, f.groups);
  for (std::string& group : f.groups) transfer_column(packing, group);
  transfer_size(packing, f.walls);
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
  limit(RLIMIT_CPU, 4 + file_size / 1'000'000);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  limit(RLIMIT_DATA, allocated() + (rlim_t(2) << 30) + 200 * file_size);
#endif
}

void send_frame(const std::filesystem::path& file, const Send& send) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(file, failed);
  limit_resources(failed ? 0 : size);
  try {
    Frame frame = read_vtp(file);
    Packer packer;
    transfer(packer, frame);
    send(packer.bytes);
  } catch (const Error&) {
    throw;
  } catch (...) {  // VTK, of a damaged file
    _exit(1);
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
  const ChildEnd end = in_child([&](const Send& send) { send_frame(file, send); });
  if (end.how == ChildEnd::not_started)
    throw Error(fmt::format("{}: cannot be read ({}); end other processes", file.string(), end.text()),
                ExitStatus::failure);
  if (end.how == ChildEnd::threw) throw Error(end.exception);
  if (end.how != ChildEnd::returned) throw damaged(file);
  try {
    Frame frame;
    Unpacker unpacker{end.sent};
    transfer(unpacker, frame);
    return frame;
  } catch (const std::length_error&) {
    throw damaged(file);
  }
}

}  // namespace scree::pictures
