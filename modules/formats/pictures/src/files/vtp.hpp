#pragma once

#include <filesystem>
#include <string>

#include <scree/pictures/frame.hpp>

namespace scree::pictures {

// The content of a VTK XML PolyData file: valid XML with compressed binary arrays.
std::string particles_vtp(const Frame& frame);
std::string contacts_vtp(const Frame& frame);
std::string surfaces_vtp(const Frame& frame);

// Reads a particles .vtp file and the contacts and surfaces files in the same directory, if any. Throws
// scree::Error.
Frame read_vtp(const std::filesystem::path& particles_file);

// Names of the arrays in the files.
namespace vtp {

inline constexpr const char* id = "id";
inline constexpr const char* material = "material";
inline constexpr const char* radius = "radius";
inline constexpr const char* velocity = "velocity";
inline constexpr const char* spin = "spin";
inline constexpr const char* coordination = "coordination";
inline constexpr const char* force = "force";
inline constexpr const char* displacement = "displacement";
inline constexpr const char* group = "group";
inline constexpr const char* group_name = "group_name";
inline constexpr const char* stress = "stress";

inline constexpr const char* normal_force = "normal_force";
inline constexpr const char* tangential_force = "tangential_force";
inline constexpr const char* overlap = "overlap";
inline constexpr const char* sliding = "sliding";
inline constexpr const char* body_a = "body_a";
inline constexpr const char* body_b = "body_b";
inline constexpr const char* wall = "wall";
inline constexpr const char* normal = "normal";
inline constexpr const char* point = "point";  // the force has the name of that of bodies

inline constexpr const char* surface = "surface";  // of each cell, an index into the names
inline constexpr const char* surface_name = "surface_name";
inline constexpr const char* torque = "torque";
inline constexpr const char* normal_stress = "normal_stress";
inline constexpr const char* shear_stress = "shear_stress";
inline constexpr const char* traction = "traction";
inline constexpr const char* sliding_work = "sliding_work";

inline constexpr const char* time = "TimeValue";  // the name that ParaView expects
inline constexpr const char* step = "step";
inline constexpr const char* dimension = "dimension";
inline constexpr const char* title = "title";
inline constexpr const char* lower = "scene_lower";
inline constexpr const char* upper = "scene_upper";
inline constexpr const char* wall_name = "wall_name";
inline constexpr const char* wall_point = "wall_point";
inline constexpr const char* wall_normal = "wall_normal";

}  // namespace vtp

// What surfaces have in each cell.
struct SurfaceMap {
  const char* name;
  std::vector<double> Surface::*values;
  std::size_t components;
};
inline constexpr SurfaceMap surface_maps[] = {{vtp::normal_stress, &Surface::normal_stress, 1},
                                              {vtp::shear_stress, &Surface::shear_stress, 1},
                                              {vtp::traction, &Surface::traction, 3},
                                              {vtp::sliding_work, &Surface::sliding_work, 1}};

}  // namespace scree::pictures
