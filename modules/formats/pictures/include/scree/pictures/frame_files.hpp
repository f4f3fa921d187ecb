#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace scree::pictures {

// Each frame has a file of every kind, and each kind a collection of its files; of surfaces if it has any.
inline constexpr const char* frame_kinds[] = {"contacts", "particles"};
inline constexpr const char* surface_kind = "surfaces";

// File of a frame: particles_0000000100.vtp.
inline std::string frame_file(const char* kind, std::uint64_t step) {
  return fmt::format("{}_{:010}.vtp", kind, step);
}
// Collection of the frames: particles.pvd.
inline std::string frame_index(const char* kind) { return fmt::format("{}.pvd", kind); }

}  // namespace scree::pictures
