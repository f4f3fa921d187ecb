#include "support.hpp"

#include <scree/packing/import.hpp>

// A packing of a format that is to be recognised.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return scree::fuzz::accept_or_refuse(
      [&] { scree::packing::parse_packing(scree::fuzz::text_of(data, size), "packing", {}); });
}
