#pragma once

#include <string>
#include <string_view>

#include <scree/packing/file_options.hpp>
#include <scree/packing/packing.hpp>

namespace scree::packing {

// Table of numbers separated by blanks, in SI units, a body in each line; '#' begins a comment. The columns
// are those that ImportOptions::columns names; or those of a first line '#format x_y_z_r_matId' of YADE; or
// of a line of names, which may be a comment, such as 'x y z r' or 'Radius[m] PosX[m] PosY[m]'; without any
// of these 3 columns are x y r, 4 are x y z r, and 5 are a SpherePack of YADE if the last is -1 everywhere.
// Columns with other names are not read. Numbers of materials (matId) count from 0, ids of YADE become 1
// larger. A line '##PERIODIC:: Lx Ly Lz' makes the box from 0 periodic. Packing::format says what was taken.
// Errors: "name:line:column: what is wrong; what to do".
Packing parse_table(std::string_view text, const std::string& name, const ImportOptions& options = {});
// Whether a line consists of names of columns with which a table can be read.
bool names_columns(std::string_view line);

// Frames of a .data file of MercuryDPM: a line 'N time xmin ymin zmin xmax ymax zmax', in two dimensions also
// 'N time xmin ymin xmax ymax', and N lines with 14 columns (x y z vx vy vz r, three angles, omega_x omega_y
// omega_z, info) or, in two dimensions, 8 (x y vx vy r angle omega info). info is the number of a species,
// from 0; with one material it is not read, and angles never are. The frame is the last, or number
// options.timestep, from 0.
Packing parse_mercury(std::string_view text, const std::string& name, const ImportOptions& options = {});

}  // namespace scree::packing
