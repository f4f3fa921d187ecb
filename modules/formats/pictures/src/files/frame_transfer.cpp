#include "frame_transfer.hpp"

#include "read_apart.hpp"
#include "vtp.hpp"

#include <cstring>
#include <stdexcept>

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
  transfer_size(packing, f.surfaces);
  for (Surface& surface : f.surfaces) {
    columns(surface.name, surface.points, surface.cells, surface.normal_stress, surface.shear_stress,
            surface.traction, surface.sliding_work);
    packing.raw(&surface.force, sizeof(surface.force));
    packing.raw(&surface.torque, sizeof(surface.torque));
  }
}

}  // namespace

Frame read_vtp_apart(const std::filesystem::path& file) {
  const Error damaged(
      fmt::format("{}: is damaged; give a particles_<step>.vtp file that a run has written, with its "
                  "contacts file as it was",
                  file.string()));
  const std::string sent = read_apart(file, damaged, [&](const Send& send) {
    Frame frame = read_vtp(file);
    Packer packer;
    transfer(packer, frame);
    send(packer.bytes);
  });
  try {
    Frame frame;
    Unpacker unpacker{sent};
    transfer(unpacker, frame);
    return frame;
  } catch (const std::length_error&) {
    throw damaged;
  }
}

}  // namespace scree::pictures
