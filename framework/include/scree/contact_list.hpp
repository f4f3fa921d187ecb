#pragma once

#include <cstdint>
#include <vector>

namespace scree {

// All touching pairs at one time, for probes and snapshots; one entry per contact.
struct ContactList {
  std::vector<std::uint32_t> a, b;    // body indices; b >= body count: plane b − body count
  std::vector<double> normal, force;  // (contacts, 3): unit vector from b to a; force on a (N)
  std::vector<double> overlap;        // (m)
  std::vector<std::uint8_t> sliding;  // 1 while the contact slides
  std::vector<std::uint32_t> law;     // index into Scene::laws
  std::vector<std::size_t> pair;      // index into the pair arrays

  std::size_t size() const { return a.size(); }
};

}  // namespace scree
