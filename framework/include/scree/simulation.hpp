#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <scree/contact_list.hpp>
#include <scree/domain.hpp>
#include <scree/particles.hpp>
#include <scree/profile.hpp>
#include <scree/scene.hpp>

namespace scree {

class BodyForces;
class Boundaries;
class Contacts;
struct SimulationParts;

// What a scene carries; it pays for nothing else.
struct Footprint {
  std::size_t degrees_of_freedom, bytes_per_body, bytes_per_pair;
  std::uint32_t history_width;  // numbers kept per pair
};

// One scene in motion. The order of a step: src/step/stepper.cpp.
class Simulation {
 public:
  // Sets everything up and evaluates the forces at t = 0. Throws Error for a scene that cannot be set up.
  explicit Simulation(const Scene& scene);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  // Advances by one time step. Throws Error(blow_up) naming particle, contact, time and cure.
  void step();
  // Takes up to `steps` steps. Faster than step(): the state is not observable in between. `proceed` is
  // polled during each step; false makes that step the last. Returns the steps taken.
  std::uint64_t run(std::uint64_t steps, const std::function<bool()>& proceed);

  // Measures the wall time of the phases of each step from now on; null ends it. The profile must outlive
  // the measurement.
  void measure(Profile* profile);

  // New parameters for a law, boundary or body force by name, between steps; histories and walls stay.
  // Throw Error for an unknown name or parameters that change the layout of the scene.
  void reconfigure_law(const std::string& name, const Parameters& parameters);
  void reconfigure_boundary(const std::string& name, const Parameters& parameters);
  void reconfigure_body_force(const std::string& name, const Parameters& parameters);
  // To be called after reconfigurations, before the next step.
  void apply_reconfiguration();

  int dimension() const;
  double time() const;         // (s)
  double step_length() const;  // (s)
  std::uint64_t steps() const;
  const Scene& scene() const;
  const Particles& particles() const;
  const Domain& domain() const;
  const std::vector<scree_plane>& planes() const;
  const std::vector<scree_load>& loads() const;         // on each plane (N)
  const std::vector<std::string>& plane_names() const;  // "<boundary>.<plane>"
  ContactList contact_list() const;

  scree_energy energy() const;
  // |residual| over the turnover of energy; 0 without an audit.
  double energy_residual() const;
  // Energy created by contact laws, over the turnover; 0 without an audit.
  double energy_created() const;
  // Net momentum created by contact forces (0 in exact arithmetic) over the momentum exchanged.
  double momentum_residual() const;
  double max_overlap_ratio() const;  // overlap over the smaller radius, largest so far
  std::uint64_t rebuilds() const;    // neighbour searches so far
  double skin() const;               // (m)
  // That of the first search (m): stated, or a tenth of the mean radius.
  double first_skin() const;
  // Shortest contact of the lightest pair of each law over the step, at the speeds expected or met so far,
  // whichever are higher; infinite without pairs.
  double min_steps_per_contact() const;
  std::uint64_t state_hash() const;
  Footprint footprint() const;

  // Internal to the framework and its tests; the types are private.
  const Boundaries& boundaries() const;
  const BodyForces& body_forces() const;
  const Contacts& contacts() const;

 private:
  void check_health(bool sound) const;

  std::unique_ptr<SimulationParts> parts_;
};

}  // namespace scree
