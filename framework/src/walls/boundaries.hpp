#pragma once

#include "plugins/clock.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <scree/body_bounds.hpp>
#include <scree/domain.hpp>
#include <scree/plugin_host.hpp>
#include <scree/resting_packing.hpp>
#include <scree/scene.hpp>
#include <scree/state.hpp>
#include <scree/wall_equations.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree {

// All boundaries of a scene: their planes, loads and states, and the periodic domain.
class Boundaries {
 public:
  // Throws Error if a plug-in refuses its parameters or to start, if two boundaries define the same periodic
  // axis, or if a plane is not finite.
  Boundaries(const std::vector<Scene::Boundary>& entries, int dimension, const BodyBounds& bodies);

  // Load of a plane (N) at the end of a step after a displacement (m) in it.
  using LoadAfter = std::function<scree_load(std::size_t plane, const double* displacement)>;

  // First half of a step: moves the planes from t to t + step (s) with the loads at t. Both halves throw
  // Error(blow_up) with plug-in, plane and time if a plane is not finite. load_after: needed if
  // displacement_speed is above 0.
  void begin_step(double time, double step, const LoadAfter& load_after = {});
  // Second half: completes velocities and energies with the loads at t + step.
  void finish_step(double time, double step);
  // For integrators that evaluate forces at mid-step: moves the planes ahead by a time (s) at constant
  // velocity, for output; and back to the positions of the force evaluation, before the next begin_step.
  void extrapolate(double time);
  void undo_extrapolation();
  // Sets new parameters of a boundary; its functions of time start again at `time` (s), but functions of the
  // keys in `going_on` continue; positions of planes are kept. A jump of kinetic energy counts as work.
  void reconfigure(const std::string& name, const Parameters& parameters, double time,
                   const std::vector<std::string>& going_on = {});

  int dimension() const { return dimension_; }
  const Domain& domain() const { return domain_; }
  const std::vector<scree_plane>& planes() const { return planes_; }
  const std::vector<scree_load>& loads() const { return loads_; }
  std::vector<scree_load>& loads() { return loads_; }
  const std::vector<std::uint32_t>& plane_materials() const { return materials_; }
  const WallSurfaces& surfaces() const { return surfaces_; }
  std::vector<scree_frame_load>& frame_loads() { return surfaces_.loads; }
  // Planes and surfaces; these are numbered behind the planes.
  std::size_t wall_count() const { return planes_.size() + surfaces_.size(); }
  std::vector<std::uint32_t> wall_materials() const;
  const std::string& wall_name(std::size_t wall) const;
  // "<boundary>.<plane>" of each plane.
  const std::vector<std::string>& plane_names() const { return names_; }
  // Mass of a wall (kg); 0 if forces do not move it.
  double wall_mass(std::size_t wall) const {
    return wall < planes_.size() ? masses_[wall] : surfaces_.masses[wall - planes_.size()];
  }
  // Of each wall, whether it exerts no force, as if it were not there.
  const std::vector<std::uint8_t>& absent() const { return absent_; }
  // Largest speed with which boundaries try displacements of planes (m/s); 0: none does.
  double displacement_speed() const { return displacement_speed_; }
  // Largest rate at which a boundary's own viscosity damps a plane (1/s); 0 without viscosity.
  double largest_damping_rate() const;
  // Sum over all boundaries.
  scree_boundary_energy energy() const;
  // Largest mid-step speed (m/s) of a plane along its normal, and with which a surface may come to where it
  // was not; infinite if any is not finite.
  double largest_speed() const;
  // reach: of each surface, how far from the origin of its frame bodies may meet it (m); empty: anywhere.
  double largest_surface_speed(std::span<const double> reach) const;
  double surface_speed(std::size_t surface, std::span<const double> reach) const;
  // How forces move walls at a time (s), with the walls where they are given. Throws Error as
  // Simulation::linear_walls does.
  WallEquations linear_walls(double time, const std::vector<scree_plane>& planes,
                             const std::vector<scree_frame>& frames) const;
  void add_to_hash(class StateHash& hash) const;
  // The walls that a state has of boundary `boundary`, and the number of all its planes and surfaces.
  struct StoredWalls {
    std::uint64_t first_plane = 0, planes = 0, first_surface = 0, surfaces = 0;
  };
  static StoredWalls stored_walls(const State& state, std::size_t boundary);
  static std::size_t plane_count(const State& state);
  static std::size_t surface_count(const State& state);
  // Takes over the walls of boundary `from` of a state for the boundary of that name; plug-in and
  // parameters of both are the same.
  void take_over(const State& state, std::size_t from, const std::string& name);
  std::size_t first_plane(std::size_t boundary) const { return members_[boundary].first_plane; }
  std::size_t first_surface(std::size_t boundary) const { return members_[boundary].first_surface; }
  // Moves the walls, at rest and with the forces of contacts on them.
  void come_to_rest(const RestingPacking& packing);
  // Begins the balance and the programs anew, at t = 0.
  void begin_anew();
  // extrapolated: the planes are ahead of the last force evaluation, as extrapolate() has left them.
  void transfer(const class StateTransfer& state, bool extrapolated);

 private:
  struct Member {
    Scene::Boundary entry;
    ConfiguredBoundary plugin;
    std::size_t first_plane, first_surface;
    Clock clock = {};
    std::vector<double> state = {};
    scree_boundary_energy energy = {};
    bool still() const { return plugin.instance().still; }
    const char* plugin_name() const { return plugin.parameters().plugin().name; }
  };
  void add(const Scene::Boundary& entry);
  void add_domain(const Member& member);
  void list_planes(const Member& member);
  void list_surfaces(const Member& member);
  void transfer_surfaces(const class StateTransfer& state, bool extrapolated);
  void take_over_surfaces(const State& state, const StoredWalls& stored, Member& member);
  // Throws Error if a frame is not as it must be; while: "at the start".
  void check_frames(const Member& member, const std::string& when, ExitStatus status) const;
  // Masses and absences of walls, which change with the parameters.
  void show_walls();
  void start(Member& member);
  void come_to_rest(Member& member, double time, const std::vector<Vec3>& displacements);
  void check_walls_against_domain() const;
  void linearise(const Member& member, double time, const std::vector<scree_plane>& at,
                 const std::vector<scree_frame>& frames, WallEquations& equations) const;
  void state_equations(const Member& member, double time, const std::vector<scree_plane>& at,
                       const std::vector<scree_frame>& frames, const scree_linear_walls& walls) const;
  scree_boundary_step step_of(Member& member, double time, double step, scree_boundary_energy& energy);
  // With these planes and numbers of state, of the boundary or copies of them.
  scree_boundary_step step_of(const Member& member, std::span<scree_plane> planes, std::span<double> state,
                              double time, double step, scree_boundary_energy& energy) const;
  std::span<scree_plane> planes_of(const Member& member);
  std::span<scree_frame> frames_of(const Member& member);
  // time_before: `time` (s) as the plug-in saw it until now.
  void change(Member& member, const ConfiguredBoundary& before, double time_before, double time);
  // Adds work and dissipated energy of a call.
  static void add_energy(Member& member, const scree_boundary_energy& energy);
  void check_finite(const Member& member, double time);
  void configure_by_clock(Member& member);
  void show_domain();
  void set_displacement_speed();

  int dimension_;
  double lower_[3], upper_[3];
  Domain domain_;
  scree_boundary_scene shared_ = {};  // what plug-ins see of the scene
  std::vector<Member> members_;
  std::vector<scree_plane> planes_, planes_before_extrapolation_;
  std::vector<scree_load> loads_;
  WallSurfaces surfaces_;
  std::vector<scree_frame> frames_before_extrapolation_;
  std::vector<std::uint32_t> materials_;
  std::vector<std::string> names_;
  std::vector<const char*> name_pointers_;
  std::vector<double> masses_;
  std::vector<std::uint8_t> absent_;
  double displacement_speed_ = 0;
};

// The boundaries of a scene at the start.
Boundaries boundaries_of(const Scene& scene);

}  // namespace scree
