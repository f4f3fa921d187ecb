#include "sample.hpp"

#include <algorithm>
#include <cstdint>

namespace scree::quasi_static {

Sample sample_of(const response::QuasiStatic& packing, double time) {
  return {.time = time,
          .planes = packing.planes(),
          .loads = packing.loads(),
          .contacts = packing.touching(),
          .sliding = packing.sliding()};
}

Sample sample_of(const Simulation& moving, double time) {
  const std::vector<std::uint8_t> sliding = moving.contact_list().sliding;
  return {.time = time,
          .planes = moving.planes(),
          .loads = moving.loads(),
          .contacts = sliding.size(),
          .sliding = std::size_t(std::count(sliding.begin(), sliding.end(), 1)),
          .dynamic = true};
}

}  // namespace scree::quasi_static
