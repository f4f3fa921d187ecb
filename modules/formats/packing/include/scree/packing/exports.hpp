#pragma once

#include <string>

#include <scree/packing/packing.hpp>

namespace scree::packing {

// Numbers in the shortest decimal form that reads back to the same bits. All throw Error if check(packing)
// does.

// A frame of extended XYZ, as OVITO and ASE read it: the cell, periodic axes and time in the second line;
// columns species, pos, radius, velo, omega, mass if all bodies have it, id. Lengths are in m. Since ASE
// knows chemical elements only, materials are H, He, Li, ... in the order in which they appear, and the
// second line names them.
std::string format_xyz(const Packing& packing);

// "x y z r" per body behind "#format x_y_z_r", as `export.text` of YADE writes and `ymport.text` reads it; in
// 2D z is 0.
std::string format_yade(const Packing& packing);

}  // namespace scree::packing
