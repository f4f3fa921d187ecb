#pragma once

#include <string>
#include <vector>

#include <scree/simulation.hpp>

namespace scree {

// One thing that bounds the time step.
struct StepLimit {
  std::string cause;    // "the contacts of law 'glass'"
  double longest_step;  // (s)
};

// What speeds are measured against (m/s): where there are walls they are at rest; without walls it is the
// mean velocity of the bodies at the start, by mass, so that a step suits a cloud however fast it flies as a
// whole.
Vec3 drift_velocity(const Scene& scene);

// Impact speed that contacts are judged at (m/s): what the scene expects, else twice the fastest body's at
// the start, against the drift velocity, but at least 1 m/s, since bodies at rest are set in motion later.
// Contact times of Hertz' law go with its fifth root.
double expected_speed(const Scene& scene);

// Shortest contact of the lightest pair that each law may meet (s); infinite if the scene has no pairs.
double shortest_contact_time(const Scene& scene, double speed);

// Everything that bounds the step of a simulation as it is now, for its integrator:
//   contacts     the step in which the lightest pair of a law is stable; where more than one contact may hold
//   a
//                body, with four times its stiffness and damping, as in the densest packing of equal spheres
//   surfaces     half the time in which a Rayleigh wave passes the smallest body, for laws that know it
//   walls        the same for a wall that forces move, whose mass is shared by the bodies that it may meet
//   viscosity    of walls, and
//   drag         of body forces: the step in which they leave a body slower rather than turn it round
//   motion       the skin, which the fastest body or wall must not cross within a step
std::vector<StepLimit> step_limits(const Simulation& simulation);
// The shortest of them.
StepLimit shortest_limit(const Simulation& simulation);

}  // namespace scree
