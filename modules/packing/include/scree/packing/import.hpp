#pragma once

#include <filesystem>
#include <string_view>

#include <scree/packing/file_options.hpp>
#include <scree/packing/packing.hpp>

namespace scree::packing {

enum class FileFormat { csv, beads, lammps_data, lammps_dump };

// Format of that name ("csv", "beads", "lammps_data", "lammps_dump"). An unknown name throws Error with the
// nearest known one.
FileFormat file_format(std::string_view name);

// Format that the first lines of a file show. Throws Error if they show none.
FileFormat detect_format(std::string_view text, std::string_view name);

// Packing from a file of any of the formats; without a format it is detected.
Packing read_packing(const std::filesystem::path& path, const ImportOptions& options = {});
Packing read_packing(const std::filesystem::path& path, FileFormat format, const ImportOptions& options = {});

}  // namespace scree::packing
