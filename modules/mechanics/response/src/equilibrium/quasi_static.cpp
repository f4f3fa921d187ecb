#include "assembly/contact_terms.hpp"
#include "equilibrium/equilibrium.hpp"
#include "equilibrium/first_event.hpp"
#include "equilibrium/static_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/response/quasi_static.hpp>
#include <scree/scene_checks.hpp>

namespace scree::response {

namespace {

// Smallest increment, relative to the longest, from which a rate of motion is taken: in shorter ones it is
// round-off.
constexpr double least_for_rate = 1e-3;
// Limit on located events per increment; contacts can chatter. The rest is taken as one step.
constexpr int most_events_located = 16;

}  // namespace

namespace {

void check_surfaces(const Simulation& simulation, const WallEquations& equations) {
  for (std::size_t w = 0; w < equations.walls.size(); ++w)
    if (equations.walls[w].turns)
      throw Error(fmt::format(
          "surface {} is turned by torques, and quasi-static loads displace walls without turning them; give it "
          "spin_control = \"fixed\"",
          simulation.wall_name(w)));
}

}  // namespace

std::vector<double> loads_of_walls(const Simulation& simulation, double time) {
  const WallEquations equations =
      simulation.linear_walls(time, simulation.planes(), simulation.surfaces().frames);
  check_equations(simulation, equations, "\"fixed\"");
  check_surfaces(simulation, equations);
  std::vector<double> loads;
  for (std::size_t w = 0; w < equations.walls.size(); ++w) {
    const scree_linear_wall& wall = equations.walls[w];
    if (wall.speed != 0)
      throw Error(fmt::format(
          "wall {} is moved with {:g} m/s at t = {:g} s; set its control to \"stress\" or \"force\": a quasi-static load is by these",
          simulation.wall_name(w), wall.speed, time));
    loads.push_back(wall.pressing_force);
  }
  return loads;
}

std::vector<std::string> laws_that_integrate_spins(const Simulation& simulation) {
  const Particles& particles = simulation.particles();
  const int spins = particles.spin_axes().last - particles.spin_axes().first;
  const ContactList list = simulation.contact_list();
  std::vector<bool> found(simulation.scene().laws.size(), false);
  for (const ContactTerms& contact : linearise_contacts(simulation, spins, AtLimit::stick))
    if (contact.integrates_spin) found[list.law[contact.contact]] = true;
  std::vector<std::string> names;
  for (std::size_t law = 0; law < found.size(); ++law)
    if (found[law]) names.push_back(simulation.scene().laws[law].name);
  return names;
}

class QuasiStatic::Packing {
 public:
  Packing(const Simulation& simulation, const QuasiStaticOptions& options)
      : simulation_(simulation),
        options_(options),
        equilibrium_(simulation, options.tolerance),
        configuration_(simulation),
        time_(simulation.time()),
        increment_end_(time_) {
    check_options();
    loads_.force.resize(configuration_.position.size());
    loads_.torque.resize(configuration_.position.size());
    if (options_.shortest_increment == 0) options_.shortest_increment = options_.longest_increment / 64;
    next_increment_ = options_.longest_increment;
    loads_of_walls(simulation_, time_);  // throws where a program moves a wall
    if (const auto varying = varying_body_force(simulation_.scene()))
      throw Error(fmt::format(
          "{} changes with time, and body forces of a quasi-static load are constant; give a number",
          *varying));
  }

  bool advance(double time) {
    // Times closer than this are the same.
    const double round_off = 1e-12 * std::max(std::abs(time), options_.longest_increment);
    while (time - time_ > round_off || !balanced_) {
      const double next = increment_end_ - time_ > round_off ? increment_end_ : time_ + next_increment_;
      if (!take(time - next > round_off ? next : time)) return false;
    }
    return true;
  }

  double time() const { return time_; }
  QuasiStaticCounts counts() const {
    return {counted_.increments, equilibrium_.iterations(), counted_.events};
  }
  std::size_t count(PairStatus status) const { return equilibrium_.contacts().count(status); }
  std::size_t size() const { return std::size_t(equilibrium_.freedom().size()); }
  std::size_t bodies() const { return equilibrium_.freedom().bodies(); }
  State state() const {
    const std::span<const Vec3> places = configuration_.position;
    const std::vector<scree_load> on_walls = wall_loads();
    return simulation_.state_at_rest({.time = time_,
                                      .bodies = places.first(bodies()),
                                      .planes = places.subspan(bodies(), simulation_.planes().size()),
                                      .loads = on_walls,
                                      .surfaces = places.subspan(bodies() + simulation_.planes().size()),
                                      .surface_loads = surface_loads(),
                                      .orientations = configuration_.orientations,
                                      .contacts = equilibrium_.contacts().touching()});
  }
  std::vector<scree_plane> planes() const { return configuration_.planes(simulation_); }
  std::vector<scree_frame> frames() const { return configuration_.frames(simulation_); }
  const std::vector<std::uint8_t>& absent_walls() const { return simulation_.absent_walls(); }
  std::vector<scree_load> wall_loads() const {
    std::vector<scree_load> all;
    for (std::size_t w = 0; w < simulation_.planes().size(); ++w) {
      const Vec3& force = loads_.force[bodies() + w];
      all.push_back({force[0], force[1], force[2]});
    }
    return all;
  }
  std::vector<scree_frame_load> surface_loads() const {
    std::vector<scree_frame_load> all;
    for (std::size_t w = bodies() + simulation_.planes().size(); w < loads_.force.size(); ++w) {
      const Vec3 &force = loads_.force[w], &torque = loads_.torque[w];
      all.push_back({{force[0], force[1], force[2]}, {torque[0], torque[1], torque[2]}});
    }
    return all;
  }

 private:
  void check_options() const {
    if (!(options_.longest_increment > 0 && std::isfinite(options_.longest_increment)))
      throw Error("a quasi-static load needs an increment above 0 s; give one");
    if (!(options_.shortest_increment >= 0 && options_.shortest_increment <= options_.longest_increment))
      throw Error(
          fmt::format("shortest increment {:g} s is not within 0 and the longest, {:g} s; give one that is",
                      options_.shortest_increment, options_.longest_increment));
    if (!(options_.tolerance > 0 && options_.tolerance < 1))
      throw Error(fmt::format("tolerance {:g} of a quasi-static load is not within 0 and 1; give one that is",
                              options_.tolerance));
  }

  // Takes an increment that ends at a time, halved until there is an equilibrium at its end. Returns false if
  // none is found.
  bool take(double time) {
    for (;;) {
      const double increment = time - time_;
      loads_of_walls(simulation_, time);  // throws where a program moves a wall
      Balance whole = equilibrium_.find(configuration_, time, increment * rate_, options_.proceed);
      if (whole.found && take_up_to_event(std::move(whole), time)) return true;
      if (increment < 1.5 * options_.shortest_increment || !options_.proceed()) return false;
      increment_end_ = time_;
      next_increment_ = std::max(0.5 * increment, options_.shortest_increment);
      time = time_ + next_increment_;
    }
  }

  // Accepts the balance at a time, or an earlier one at an event. Returns false if the balance at the event
  // is not found again.
  bool take_up_to_event(Balance whole, double time) {
    const double increment = time - time_;
    if (time != increment_end_) events_located_ = 0;
    increment_end_ = time;
    if (!(increment > 0) || events_located_ == most_events_located || equilibrium_.contacts().events() == 0) {
      accept(std::move(whole), time, increment);
      return true;
    }
    FirstEvent event(equilibrium_, configuration_, time_, increment, std::move(whole), options_.proceed);
    const double share = event.find();
    if (share == 0) return false;
    if (share < 1) ++events_located_;
    accept(event.take_balance(), share < 1 ? time_ + share * increment : time, share * increment);
    return true;
  }

  void accept(Balance balance, double time, double increment) {
    ++counted_.increments;
    counted_.events += equilibrium_.contacts().events();
    if (increment > least_for_rate * options_.longest_increment)
      rate_ = 1 / increment * equilibrium_.without_free_bodies(balance.motion);
    equilibrium_.accept(balance);
    configuration_ = std::move(balance.at);
    loads_ = std::move(balance.loads);
    time_ = time;
    balanced_ = true;
    next_increment_ = std::min(options_.longest_increment, 2 * next_increment_);
  }

  const Simulation& simulation_;
  QuasiStaticOptions options_;
  Equilibrium equilibrium_;
  StaticConfiguration configuration_;
  StaticLoads loads_;
  Eigen::VectorXd rate_;  // of the motion in the last increment (1/s); empty before the first
  double time_, next_increment_ = 0;
  double increment_end_;    // (s) planned end of the present increment, which events may divide
  int events_located_ = 0;  // in that increment
  bool balanced_ = false;
  QuasiStaticCounts counted_;
};

QuasiStatic::QuasiStatic(const Simulation& simulation, const QuasiStaticOptions& options)
    : packing_(std::make_unique<Packing>(simulation, options)) {}
QuasiStatic::~QuasiStatic() = default;

bool QuasiStatic::advance(double time) { return packing_->advance(time); }
double QuasiStatic::time() const { return packing_->time(); }
QuasiStaticCounts QuasiStatic::counts() const { return packing_->counts(); }
std::size_t QuasiStatic::degrees_of_freedom() const { return packing_->size(); }
std::size_t QuasiStatic::touching() const {
  return packing_->count(PairStatus::sticks) + packing_->count(PairStatus::slides);
}
std::size_t QuasiStatic::sliding() const { return packing_->count(PairStatus::slides); }
std::vector<scree_plane> QuasiStatic::planes() const { return packing_->planes(); }
std::vector<scree_load> QuasiStatic::loads() const { return packing_->wall_loads(); }
std::vector<scree_frame> QuasiStatic::frames() const { return packing_->frames(); }
std::vector<scree_frame_load> QuasiStatic::surface_loads() const { return packing_->surface_loads(); }
const std::vector<std::uint8_t>& QuasiStatic::absent_walls() const { return packing_->absent_walls(); }
State QuasiStatic::state() const { return packing_->state(); }

}  // namespace scree::response
