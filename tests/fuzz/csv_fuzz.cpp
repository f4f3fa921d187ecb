#include "support.hpp"

#include <scree/packing/csv.hpp>

// A packing as CSV; what can be written can be read again.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scree::packing;
  return scree::fuzz::accept_or_refuse([&] {
    const Packing read = parse_csv(scree::fuzz::text_of(data, size), "packing.csv");
    if (parse_csv(format_csv(read), "again.csv").bodies.size() != read.bodies.size()) std::abort();
  });
}
