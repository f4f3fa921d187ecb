#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <scree/packing/packing.hpp>

namespace scree::packing {

// What an importer needs beyond the file. Each reader ignores the options that its format has no use for.
struct ImportOptions {
  std::optional<int> dimension{};                 // 2 or 3; absent: as in the file, else 3
  std::optional<std::array<bool, 3>> periodic{};  // absent: as in the file, else none
  std::vector<std::string> materials{};           // names of types 1, 2, ...; empty: the type number as text
  std::optional<std::int64_t> timestep{};         // frame of a dump; absent: the last frame
  std::vector<std::string> columns{};             // of a table without names, "-" for those not to be read
};

// Program that is to read the file; each rejects some details of the other's files.
enum class Dialect { lammps, liggghts };

// What an exporter needs beyond the packing.
struct ExportOptions {
  Dialect dialect = Dialect::lammps;
  // Materials of types 1, 2, ...; empty: if every name is a number, it is the type; otherwise types are
  // numbered in order of appearance. Bodies without a material are type 1.
  std::vector<std::string> materials{};
  double density = unset;     // (kg/m³) for bodies that have neither density nor mass
  std::int64_t timestep = 0;  // of a dump frame
};

}  // namespace scree::packing
