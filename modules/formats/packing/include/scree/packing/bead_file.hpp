#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <scree/packing/file_options.hpp>
#include <scree/packing/packing.hpp>

namespace scree::packing {

// Plain bead list: first line "N L H", then N lines "x y z radius". (m)
// Periodic in x and z with period L from 0, walls at y = 0 and y = H. Ids are 1, 2, ... in file order.
// Of the options only `periodic` is used. Errors: "name:line:column: what is wrong; what to do".
Packing read_beads(const std::filesystem::path& path, const ImportOptions& options = {});
Packing parse_beads(std::string_view text, const std::string& name, const ImportOptions& options = {});

}  // namespace scree::packing
