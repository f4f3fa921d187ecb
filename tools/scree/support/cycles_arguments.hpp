#pragma once

#include "support/verbs.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scree::tool {

// What `scree cycles` takes.
struct CyclesArguments {
  std::vector<std::string> directories;
  std::string csv, probe, strain, load, touching, out;
  double period = 0, round_off = 0;  // 0: not given
  std::optional<double> first_minimum;
  std::uint64_t drop = 29;
  bool overwrite = false;
};

// Adds the verb `cycles` with its options; the caller gives it its action.
Verb add_cycles_options(CommandLine& line, CyclesArguments& arguments);

}  // namespace scree::tool
