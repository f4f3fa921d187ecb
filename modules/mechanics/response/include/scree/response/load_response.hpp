#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <scree/response/linear_system.hpp>

namespace scree::response {

// A contact, and how its force changes with a load.
struct LoadedContact {
  std::uint32_t a, b;                       // as in ContactList
  bool sliding;                             // in the last step
  double normal_force, tangential_force;    // (N)
  double normal_change, tangential_change;  // (N/N)
};

// Response of a packing at rest to a growing force on one wall, per force: the straight paths of bodies and
// contact forces while no contact opens, closes, begins or ends to slide (McNamara et al. 2008, equation A6).
struct LoadResponse {
  std::size_t wall;           // on which the force grows, along its direction of motion
  std::vector<double> walls;  // (m/N) displacement of each wall along its direction; 0 if no force moves it
  std::vector<std::uint32_t> bodies;  // that are held
  std::vector<double> displacement;   // (m/N; rad/N of rotations) (bodies, dimension + spins)
  // Contacts of held bodies. The tangential force is n × f in 2D; in 3D it is the magnitude, whose change is
  // the component of the change along the force, or all of the change if there is no force.
  std::vector<LoadedContact> contacts;
  double residual;  // of K q = f

  // A residual above this is not round-off: the load drives a floppy mode.
  static constexpr double largest_residual = 1e-6;
};

// Throws Error if forces move no wall.
void check_loaded_walls(const Simulation& simulation);

// Computes one response for each wall that forces move and a held body touches. Throws Error as assemble()
// does, if there is no such wall, or (interrupted) if `proceed` returns false.
std::vector<LoadResponse> load_responses(
    const Simulation& simulation, const AssemblyOptions& options = {},
    const std::function<bool()>& proceed = [] { return true; });

}  // namespace scree::response
