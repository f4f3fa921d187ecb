#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <scree/packing/file_options.hpp>
#include <scree/packing/packing.hpp>

namespace scree::packing {

// LAMMPS and LIGGGHTS data file (read_data) of atom style sphere or granular, in SI units: header, Atoms with
// "id type diameter density x y z [ix iy iz]", Velocities with "id vx vy vz wx wy wz". Masses and
// coefficients are skipped; bonds, other shapes and tilted boxes are refused. Image flags are checked and
// dropped: positions stay those in the box. Periodic axes and dimension come from the options, as the format
// has no place for them. The density is of spheres in two dimensions too, which gives bodies their mass.
// Errors: "name:line:column: what is wrong; what to do".
Packing read_lammps_data(const std::filesystem::path& path, const ImportOptions& options = {});
Packing parse_lammps_data(std::string_view text, const std::string& name, const ImportOptions& options = {});

// Writes such a file. Numbers in the shortest decimal form that reads back to the same bits; without bounds
// the box encloses the bodies. A body given by its mass gets the density of a sphere. Throws Error for a body
// without density, and for one outside the box along a non-periodic axis, which LAMMPS and
// LIGGGHTS would lose.
void write_lammps_data(const Packing& packing, const std::filesystem::path& path,
                       const ExportOptions& options = {});
std::string format_lammps_data(const Packing& packing, const ExportOptions& options = {});

// One frame of a text dump (dump custom): the last, or the last one with options.timestep.
// Columns in any order: id, type, x | xs | xu | xsu (and y, z), radius | diameter, vx vy vz, omegax omegay
// omegaz, mass, density; others are ignored. Required are the position and the size; without id the bodies
// are numbered in file order. Unwrapped coordinates are wrapped into the box along periodic axes.
Packing read_lammps_dump(const std::filesystem::path& path, const ImportOptions& options = {});
Packing parse_lammps_dump(std::string_view text, const std::string& name, const ImportOptions& options = {});

// Writes one frame. Density and mass are columns if every body has them; throws Error if only some do. The
// dialect lammps also records units and time, which LIGGGHTS does not read.
void write_lammps_dump(const Packing& packing, const std::filesystem::path& path,
                       const ExportOptions& options = {});
std::string format_lammps_dump(const Packing& packing, const ExportOptions& options = {});

}  // namespace scree::packing
