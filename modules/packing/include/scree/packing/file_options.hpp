#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <scree/packing/packing.hpp>

namespace scree::packing {

// What an importer is told beyond the file. A reader ignores what does not concern its format.
struct ImportOptions {
  std::optional<int> dimension{};                 // 2 or 3; absent: the file's, otherwise 3
  std::optional<std::array<bool, 3>> periodic{};  // absent: the file's, otherwise none
  std::vector<std::string> materials{};           // of types 1, 2, ...; empty: the type number as text
  std::optional<std::int64_t> timestep{};         // frame of a dump; absent: the last one
};

// Who is to read a file: they differ in small things that each refuses from the other.
enum class Dialect { lammps, liggghts };

// What an exporter is told beyond the packing.
struct ExportOptions {
  Dialect dialect = Dialect::lammps;
  // Materials of types 1, 2, ...; empty: names that are numbers stand for themselves, others in order of
  // appearance; bodies without a material are type 1.
  std::vector<std::string> materials{};
  double density = unset;     // (kg/m³) of bodies that have neither density nor mass
  std::int64_t timestep = 0;  // of a dump frame
};

}  // namespace scree::packing
