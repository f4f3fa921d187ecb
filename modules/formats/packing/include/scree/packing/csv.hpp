#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <scree/packing/file_options.hpp>
#include <scree/packing/packing.hpp>

namespace scree::packing {

// Comma-separated values. The header names the columns, in any order, each optionally with its SI unit: id,
// material, x [m], y [m], z [m], radius [m] or diameter [m], density [kg/m^3], mass [kg], vx [m/s], vy, vz,
// spin_x [rad/s], spin_y, spin_z; [kg/m3] and wx, wy, wz are read too. Required are x, y and the size.
// Without z the packing has two dimensions; ids default to 1, 2, ..., other absent columns and empty cells to
// the defaults of Body. Comment lines before the header may carry "# dimension: 3", "# time [s]: 0", "# lower
// [m]: 0 0 0", "# upper [m]: 1 1 1", "# periodic: x z". Of the options only `dimension` and `periodic` are
// used. Errors: "name:line:column: what is wrong; what to do".
Packing read_csv(const std::filesystem::path& path, const ImportOptions& options = {});
Packing parse_csv(std::string_view text, const std::string& name, const ImportOptions& options = {});

// Each number in the shortest decimal form that reads back to the same bits. Throws Error if check(packing)
// does, or if the file cannot be written.
void write_csv(const Packing& packing, const std::filesystem::path& path);
std::string format_csv(const Packing& packing);
// Whether a text can be written as a cell: no comma, quote, control character or outer blank.
bool fits_csv_cell(std::string_view text);

}  // namespace scree::packing
