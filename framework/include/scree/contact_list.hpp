#pragma once

#include <cstdint>
#include <vector>

namespace scree {

// All touching pairs at one moment, for probes and snapshots.
struct ContactList {
  std::vector<std::uint32_t> a, b;    // b >= body count: plane b − body count
  std::vector<double> normal, force;  // (contacts, 3) force on a (N)
  std::vector<double> overlap;        // (m)
  std::vector<std::uint8_t> sliding;
  std::vector<std::size_t> pair;  // index into the pair arrays

  std::size_t size() const { return a.size(); }
};

}  // namespace scree
