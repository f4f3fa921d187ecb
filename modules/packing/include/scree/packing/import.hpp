#pragma once

#include <filesystem>
#include <string_view>

#include <scree/packing/file_options.hpp>
#include <scree/packing/packing.hpp>

namespace scree::packing {

enum class FileFormat { csv, beads, lammps_data, lammps_dump };

// Format by name ("csv", "beads", "lammps_data", "lammps_dump"). Throws Error for an unknown name, with the
// nearest known one.
FileFormat file_format(std::string_view name);

// Format recognised from the first lines of a file. Throws Error if none fits.
FileFormat detect_format(std::string_view text, std::string_view name);

// Reads a packing from a file of any of these formats; the first overload detects the format.
Packing read_packing(const std::filesystem::path& path, const ImportOptions& options = {});
Packing read_packing(const std::filesystem::path& path, FileFormat format, const ImportOptions& options = {});

}  // namespace scree::packing
