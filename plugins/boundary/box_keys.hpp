#pragma once

// Names of the walls of a box, and keys of each axis and wall.
namespace box {

inline constexpr int max_walls = 6;

inline constexpr const char* wall_names[max_walls] = {"x_low",  "x_high", "y_low",
                                                      "y_high", "z_low",  "z_high"};
struct AxisKeys {
  const char *control, *stress, *strain_rate;
};
inline constexpr AxisKeys axis_keys[3] = {{"x", "stress_x", "strain_rate_x"},
                                          {"y", "stress_y", "strain_rate_y"},
                                          {"z", "stress_z", "strain_rate_z"}};
struct WallKeys {
  const char *stress, *displacement, *velocity, *superposed;
};
inline constexpr WallKeys wall_keys[max_walls] = {
    {"stress_x_low", "displacement_x_low", "velocity_x_low", "superposed_x_low"},
    {"stress_x_high", "displacement_x_high", "velocity_x_high", "superposed_x_high"},
    {"stress_y_low", "displacement_y_low", "velocity_y_low", "superposed_y_low"},
    {"stress_y_high", "displacement_y_high", "velocity_y_high", "superposed_y_high"},
    {"stress_z_low", "displacement_z_low", "velocity_z_low", "superposed_z_low"},
    {"stress_z_high", "displacement_z_high", "velocity_z_high", "superposed_z_high"}};

}  // namespace box
