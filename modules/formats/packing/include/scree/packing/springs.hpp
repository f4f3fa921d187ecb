#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <scree/plugin/vec.hpp>

namespace scree::packing {

// Tangential spring of a contact between two bodies (ids).
struct Spring {
  std::int64_t a = 0, b = 0;
  Vec3 displacement{};   // (m) of a's contact point relative to b's while they stuck
  std::size_t line = 0;  // in the file
};

struct SpringOptions {
  // Names of the columns, "-" for columns that are not read; empty: as in the line "ITEM: ENTRIES". Read are
  // a, b (ids), spring_x, spring_y and, in three dimensions, spring_z.
  std::vector<std::string> columns{};
  std::optional<std::int64_t> timestep{};  // frame of the dump; absent: the last
  double factor = 1;                       // times each number gives the displacement (m)
  int dimension = 3;
};

// Reads the springs of one frame of a dump of LAMMPS or LIGGGHTS (dump local). Throws Error
// "file:line:column: problem; cure" also for a pair that is listed twice.
std::vector<Spring> read_springs(const std::filesystem::path& path, const SpringOptions& options);
std::vector<Spring> parse_springs(std::string_view text, const std::string& name,
                                  const SpringOptions& options);

}  // namespace scree::packing
