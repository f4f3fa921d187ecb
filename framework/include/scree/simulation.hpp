#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <scree/branching.hpp>
#include <scree/contact_list.hpp>
#include <scree/domain.hpp>
#include <scree/particles.hpp>
#include <scree/profile.hpp>
#include <scree/resting_packing.hpp>
#include <scree/scene.hpp>
#include <scree/state.hpp>
#include <scree/wall_equations.hpp>

namespace scree {

class BodyForces;
class Boundaries;
class Contacts;
class Probe;
class Ranks;
struct SimulationParts;
struct WallSurfaces;

// Memory and degrees of freedom of a scene; it carries only what its laws need.
struct Footprint {
  std::size_t degrees_of_freedom, fixed_bodies, held_bodies, bytes_per_body, bytes_per_pair;  // held: in part
  std::uint32_t history_width;  // history columns per pair, the most of any law
  std::size_t listed_pairs;     // of bodies, and of bodies and planes
  std::size_t touching_pairs;   // of these
  double crossing_share;        // of the listed pairs of bodies, those between two tiles, which take longer
  std::size_t foreign_bodies;   // that ranks read although other ranks have them, summed over ranks
  std::size_t bytes_sent;       // between ranks in an evaluation
  bool by_graph;                // ranks have the tiles that Ranks::partition has found, not consecutive ones
};

// A running simulation of one scene. The sequence of a step is listed in src/step/stepper.cpp.
class Simulation {
 public:
  // Sets up the scene and evaluates the forces at t = 0. Throws Error for an invalid scene.
  // ranks: that compute it together with this one, the first of them, while they are in follow_first_rank();
  // or null.
  explicit Simulation(Scene scene, Ranks* ranks = nullptr);
  // Goes on from a state of the same scene, to the same bits as if it had never stopped. The scene has the
  // bodies of the start (see scene_record.hpp) and the parameters of the present stage. Throws Error if the
  // state belongs to another scene.
  Simulation(const Scene& scene, const State& state, Ranks* ranks = nullptr);
  // Begins at t = 0 from a state of another simulation, whose bodies come first in the scene, as they were in
  // the state (see branching.hpp). Without other changes the motion goes on to the same bits. Throws Error if
  // something in the state has no place in the scene.
  Simulation(const Scene& scene, const State& state, const Branching& branching, Ranks* ranks = nullptr);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  // Advances by one time step. Throws Error(blow_up) with the particle or contact, the time and a remedy.
  void step();
  // The same, to the same bits; the bodies are complete after each substep of this length (s), which may be
  // below 0. fourth_order has five, other integrators one.
  void step(const std::function<void(double length)>& after_substep);
  // Takes up to `steps` steps. Faster than step(): the state is not observable in between. `proceed` is
  // polled during each step; false makes that step the last. Returns the steps taken.
  std::uint64_t run(std::uint64_t steps, const std::function<bool()>& proceed);

  // Adds the wall time of each phase of later steps to a profile, which must outlive the measurement; null
  // stops.
  void measure(Profile* profile);

  // Set new parameters for a law, boundary or body force by name, between steps; histories and wall positions
  // are kept. Functions of time start again, but those of keys in `going_on` continue. Throw Error for an
  // unknown name or for parameters that change the layout of the scene.
  void reconfigure_law(const std::string& name, const Parameters& parameters);
  void reconfigure_boundary(const std::string& name, const Parameters& parameters,
                            const std::vector<std::string>& going_on = {});
  void reconfigure_body_force(const std::string& name, const Parameters& parameters,
                              const std::vector<std::string>& going_on = {});
  // Throws Error if such new parameters of a boundary would bring back a wall that is absent, with bodies
  // behind it.
  void check_returning_walls(const std::string& name, const Parameters& parameters,
                             const std::vector<std::string>& going_on = {});
  // Must be called after reconfigurations, before the next step. Throws Error if a wall that was absent has
  // bodies behind it.
  void apply_reconfiguration();

  int dimension() const;
  double time() const;         // (s)
  double step_length() const;  // (s)
  std::uint64_t steps() const;
  const Scene& scene() const;
  // In scene order. Valid until the next step: later the same reference may be an old copy, or have the
  // bodies in another order.
  const Particles& particles() const;
  // The same, in which only bodies of these numbers need be as they are now: costs less. Constants are right.
  const Particles& particles(const std::vector<std::uint32_t>& numbers) const;
  const Domain& domain() const;
  const std::vector<scree_plane>& planes() const;
  const std::vector<scree_load>& loads() const;  // contact force on each plane (N)
  const std::vector<std::uint8_t>& absent_walls()
      const;  // of each plane, then surface, whether it exerts no force: it is not there
  const std::vector<std::string>& plane_names() const;  // "<boundary>.<plane>"
  const std::vector<std::uint32_t>& plane_materials() const;
  // Walls that are no planes. In a contact list they are numbered behind the planes.
  const WallSurfaces& surfaces() const;
  // What friction has dissipated on each facet of a surface (J), see facets_of(); empty if the scene keeps
  // none.
  std::vector<double> sliding_work(std::size_t surface) const;
  // Largest speed (m/s) with which a surface came to where it was not, among the bodies, in the last step.
  double surface_speed(std::size_t surface) const;
  // Of a wall as contact lists number them, from 0.
  const std::string& wall_name(std::size_t wall) const;
  // Length along each axis (m) between the walls that enclose the bodies, or the period; NaN along an axis
  // that is not enclosed. Now, and at t = 0.
  Vec3 lengths() const;
  const Vec3& lengths_at_start() const;
  // What a probe adds up over the bodies and contacts of all tiles: the same bits on any number of threads
  // and ranks. Empty if it has no totals.
  std::vector<double> totals_of(const Probe& probe) const;
  ContactList contact_list() const;
  // The same and pairs that are apart now, but between which the last evaluation, at other positions than the
  // present ones (position_verlet, predictor_corrector), found a force; the overlap of these is 0 or below.
  ContactList loaded_contact_list() const;
  // How forces move the walls about their present state. Throws Error if a boundary states numbers that are
  // not finite, a negative mass or viscosity, or a direction that is no unit vector.
  WallEquations linear_walls() const;
  // The same at another time (s) of the present stage, with the walls elsewhere: as many planes and surfaces
  // as this simulation has.
  WallEquations linear_walls(double time, const std::vector<scree_plane>& planes,
                             const std::vector<scree_frame>& frames) const;
  // What the law of a pair of the contact list keeps in a history column; 0 for columns that it does not
  // have.
  double contact_history(std::size_t pair, std::uint32_t column) const;
  // What was taken over from a state, "walls of 'box'"; empty for a new packing.
  const std::vector<std::string>& taken_over() const;
  // What was lost of a state from which the simulation began, "<what>; <cure>". Its energy counts as
  // dissipated.
  const std::vector<std::string>& let_go() const;

  scree_energy energy() const;
  // |residual| / turnover of the energy balance; 0 without an audit, NaN if an energy was not finite.
  double energy_residual() const;
  // Energy created by contact laws / turnover; 0 without an audit, NaN if an energy was not finite.
  double energy_created() const;
  // Net momentum created by contact forces (0 in exact arithmetic) over the momentum exchanged.
  double momentum_residual() const;
  double max_overlap_ratio() const;  // overlap / smaller radius, largest so far
  std::uint64_t rebuilds() const;    // neighbour searches so far
  double skin() const;               // (m)
  // Skin of the first search (m): as given, or a tenth of the mean radius.
  double first_skin() const;
  // Shortest contact time of any law's lightest pair / time step, at the expected impact speed or the largest
  // one possible so far, whichever is higher; infinite without pairs.
  double min_steps_per_contact() const;
  std::uint64_t state_hash() const;
  // Everything that the simulation is, between two steps: its scene (see scene_record.hpp) and what has
  // changed since the start.
  State state() const;
  // The same in two parts: what changes, copied between two steps, and what stays as it was at the start
  // (bodies and their first motion), which may be added by another thread while the simulation goes on.
  State changing_state() const;
  void add_unchanging_state(State& state) const;
  // The state of this simulation with its bodies and walls at rest in other places, with other contacts, at
  // another time of the present stage, rounded to whole steps. All else is as it is now. Throws Error if a
  // contact is listed whose bodies are apart.
  State state_at_rest(const RestingPacking& packing) const;
  Footprint footprint() const;

  // For the framework and its tests only; the types are private.
  const Boundaries& boundaries() const;
  const BodyForces& body_forces() const;
  // Adds the body forces of a time (s), by default the present one, to the loads of bodies.
  void add_body_forces(scree_body_batch& batch) const;
  void add_body_forces(scree_body_batch& batch, double time) const;
  const Contacts& contacts() const;

  // Whether another rank had been asked to stop, as of the last step.
  bool is_interrupted_elsewhere() const;

 private:
  friend class Follower;
  explicit Simulation(std::unique_ptr<SimulationParts> parts);
  // Has the other ranks compute their shares from now on.
  void share_with(Ranks* ranks);
  // Takes one step; `observed`: the bodies must be complete at its end.
  void advance(bool observed, const std::function<void(double)>* after_substep = nullptr);
  void check_health(bool sound) const;
  // Pairs that touch, and on request those that are apart but loaded.
  ContactList listed_contacts(bool loaded) const;
  void start_springs();
  void start_audits();

  std::unique_ptr<SimulationParts> parts_;
};

}  // namespace scree
