#pragma once

#include <string>
#include <vector>

#include <scree/simulation.hpp>

namespace scree {

// An upper limit of the time step and its cause.
struct StepLimit {
  std::string cause;    // "the contacts of law 'glass'"
  double longest_step;  // (s)
};

// Reference velocity for speeds (m/s): zero in a scene with walls; without walls the initial velocity of the
// centre of mass, so that the limit does not depend on the motion of a cloud as a whole.
Vec3 drift_velocity(const Scene& scene);

// Impact speed v for which contact times are computed (m/s): Scene::expected_speed if given, else twice the
// largest initial speed relative to the drift velocity, but at least 1 m/s, since bodies at rest may be set
// in motion later. Hertzian contact times scale as v^(−1/5).
double expected_speed(const Scene& scene);

// Shortest contact time (s) of any law's lightest pair at an impact speed (m/s); infinite without pairs.
double shortest_contact_time(const Scene& scene, double speed);

// All limits of the time step of a simulation in its present state, for its integrator:
//   contacts     longest stable step of the lightest pair of each law; where a body may have several
//                contacts, with four times the stiffness and damping, as in the densest packing of spheres
//   surfaces     half the time in which a Rayleigh wave crosses the smallest body, for laws that state it
//   walls        as for contacts, for walls moved by forces; the bodies they may touch share their mass
//   viscosity    of walls, and
//   drag         of body forces: the longest step in which drag slows the motion without reversing it
//   motion       the fastest body or wall must not cross the skin within one step
std::vector<StepLimit> step_limits(const Simulation& simulation);
// The smallest of these limits; infinite without any.
StepLimit shortest_limit(const Simulation& simulation);

}  // namespace scree
