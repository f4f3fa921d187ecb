#pragma once

#include <string>
#include <vector>

#include <scree/wall_surfaces.hpp>

namespace scree {

class Particles;

// A line for each mesh: "pot: 12 triangles from (0, 0, 0) to (1, 1, 1) m, closed; 1 triangle of no area,
// left out".
std::vector<std::string> mesh_lines(const WallSurfaces& surfaces);

// Meshes whose size does not fit the bodies, as of a file in mm.
std::vector<std::string> mesh_warnings(const WallSurfaces& surfaces, const Particles& bodies);

// Throws Error if the centre of a body that can move is behind a surface with one side, or if a mesh with one
// side crosses itself.
void check_sides(const WallSurfaces& surfaces, const Particles& bodies);

}  // namespace scree
