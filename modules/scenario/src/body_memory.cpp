#include "body_memory.hpp"

#include <fmt/format.h>

#include <scree/available_memory.hpp>

namespace scree::scenario {

namespace {

// Peak memory (bytes) per body from reading to running, including neighbours and contacts.
constexpr double memory_per_body = 2000;

}  // namespace

void check_body_memory(const document::Table& table, std::string_view key, double bodies) {
  const double there = available_memory();
  if (bodies * memory_per_body > there)
    throw table.error(
        key,
        fmt::format("{:g} bodies need about {:.3g} GB of memory, but this computer has {:.3g} GB", bodies,
                    1e-9 * bodies * memory_per_body, 1e-9 * there),
        fmt::format("give at most {:.2g}", there / memory_per_body));
}

}  // namespace scree::scenario
