#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <scree/orientations.hpp>
#include <scree/plugin/abi.h>
#include <scree/plugin/vec.hpp>
#include <scree/surface_place.hpp>

namespace scree {

// What the law of a touching pair keeps.
struct ContactHistory {
  std::uint32_t a, b;                    // as in ContactList
  std::span<const double> numbers;       // as many as the history of the law has
  std::optional<SurfaceSpot> spot = {};  // on a mesh
  std::uint32_t spot_number = 0;         // among the spots of a and a mesh
};

// The bodies and walls of a simulation at rest in other places; see Simulation::state_at_rest.
struct RestingPacking {
  double time;                                      // (s)
  std::span<const Vec3> bodies;                     // (m) centres, without jumps at periodic faces
  std::span<const Vec3> planes;                     // (m) points of the planes
  std::span<const scree_load> loads;                // (N) forces of contacts on the planes
  std::span<const Vec3> surfaces;                   // (m) origins of the frames of the surfaces
  std::span<const scree_frame_load> surface_loads;  // (N), (N m) of contacts on the surfaces
  const Orientations& orientations;                 // if the simulation carries them
  std::vector<ContactHistory> contacts;             // all that touch, in any order
};

}  // namespace scree
