#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <scree/packing/file_options.hpp>
#include <scree/packing/packing.hpp>

namespace scree::packing {

enum class FileFormat { csv, beads, lammps_data, lammps_dump, table, mercury };

// Format by name ("csv", "beads", "lammps_data", "lammps_dump", "table", "mercury"). Throws Error for an
// unknown name, with the nearest known one.
FileFormat file_format(std::string_view name);

// Format recognised from the first lines of a file. Throws Error if none fits.
FileFormat detect_format(std::string_view text, std::string_view name);

// Reads a packing of any of these formats; without one the format is detected. name stands for the file in
// messages.
Packing parse_packing(std::string_view text, const std::string& name, const ImportOptions& options = {});
Packing read_packing(const std::filesystem::path& path, const ImportOptions& options = {});
Packing read_packing(const std::filesystem::path& path, FileFormat format, const ImportOptions& options = {});

}  // namespace scree::packing
