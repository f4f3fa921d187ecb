#include "support.hpp"

#include <scree/packing/lammps.hpp>

// A data file of LAMMPS.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return scree::fuzz::accept_or_refuse(
      [&] { scree::packing::parse_lammps_data(scree::fuzz::text_of(data, size), "packing.data", {}); });
}
