#include "driven_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/plugin/program.hpp>
#include <scree/wall_equations.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree::spectrum {

namespace {

Parameters with_wave(const Scene& scene, const SpectrumPlan& plan, const Wave& wave) {
  Parameters parameters = std::find_if(scene.boundaries.begin(), scene.boundaries.end(), [&](const auto& b) {
                            return b.name == plan.boundary;
                          })->parameters;
  parameters.set(plan.key, wave);
  return parameters;
}

}  // namespace

void set_wave(Scene& scene, const SpectrumPlan& plan, const Wave& wave) {
  for (Scene::Boundary& boundary : scene.boundaries)
    if (boundary.name == plan.boundary) boundary.parameters = with_wave(scene, plan, wave);
}

void start_wave(Simulation& simulation, const SpectrumPlan& plan, const Wave& wave) {
  try {
    simulation.reconfigure_boundary(plan.boundary, with_wave(simulation.scene(), plan, wave));
  } catch (const Error& error) {
    throw error.at(plan.drive_place, ExitStatus::bad_input);
  }
  simulation.apply_reconfiguration();
}

namespace {

// (m) Points of the planes, then origins of the frames of surfaces.
std::vector<Vec3> places_of_walls(const Simulation& simulation) {
  std::vector<Vec3> all;
  for (const scree_plane& plane : simulation.planes()) all.push_back(vector_of(plane.point));
  for (const scree_frame& frame : simulation.surfaces().frames) all.push_back(vector_of(frame.position));
  return all;
}

bool any_turns(const Simulation& simulation) {
  const std::vector<scree_frame>& frames = simulation.surfaces().frames;
  return std::any_of(frames.begin(), frames.end(), [](const scree_frame& frame) {
    return dot(vector_of(frame.spin), vector_of(frame.spin)) > 0;
  });
}

// Velocity of each wall (m/s) at the start of a drive of this speed (m/s).
std::vector<Vec3> velocities(Simulation& copy, const SpectrumPlan& plan, double speed) {
  const bool turned = any_turns(copy);
  start_wave(copy, plan, {Program::ramp, 0, speed, 1});
  if (!turned && any_turns(copy))
    throw Error(fmt::format(
        "{}: '{}' of '{}' turns a wall, and spectra are driven by walls that are displaced; drive a displacement, "
        "a velocity or a superposed motion",
        plan.drive_place, plan.key, plan.boundary));
  std::vector<Vec3> all;
  for (const scree_plane& plane : copy.planes()) all.push_back(vector_of(plane.velocity));
  for (const scree_frame& frame : copy.surfaces().frames) all.push_back(vector_of(frame.velocity));
  return all;
}

}  // namespace

DrivenWalls::DrivenWalls(const Start& start) {
  Simulation copy(start.scene, start.state);
  const SpectrumPlan& plan = start.spectrum;
  at_rest_ = places_of_walls(copy);
  // Slow compared with any motion of the scene, since limits of speed hold for walls too.
  const double speed = 2 * plan.from_hz * plan.amplitude;
  const std::vector<Vec3> still = velocities(copy, plan, 0), moving = velocities(copy, plan, speed);
  const WallEquations equations = copy.linear_walls();
  for (std::size_t w = 0; w < still.size(); ++w) {
    motion_.push_back((1 / speed) * (moving[w] - still[w]));
    square_ += dot(motion_[w], motion_[w]);
    const bool driven = dot(motion_[w], motion_[w]) > 0;
    const scree_linear_wall& equation = equations.walls[w];
    prescribed_ &= !driven || equation.free == SCREE_PRESCRIBED;
    if (driven && equation.free == SCREE_FREE && equation.mass == 0 && equation.viscosity == 0)
      throw Error(fmt::format(
          "{}: a servo or massless wall keeps its load, so that '{}' of '{}' drives nothing; give the wall control = "
          "\"force\" or \"stress\" with a mass, or drive the opposite wall",
          plan.drive_place, plan.key, plan.boundary));
  }
  if (square_ == 0)
    throw Error(
        fmt::format("{}: '{}' of '{}' moves no wall with its present control; set the control that uses it",
                    plan.drive_place, plan.key, plan.boundary));
}

double DrivenWalls::drive_of(const Simulation& simulation) const {
  const std::vector<Vec3> places = places_of_walls(simulation);
  double sum = 0;
  for (std::size_t w = 0; w < places.size(); ++w) sum += dot(motion_[w], places[w] - at_rest_[w]);
  return sum / square_;
}

void check_amplitude(const Start& start, double amplitude) {
  // Displacements in a step are smaller than the amplitude by the steps in a radian.
  constexpr double least_share = 1000;
  const Simulation simulation(start.scene, start.state);
  double largest = 0;
  for (const Vec3& place : places_of_walls(simulation))
    for (const double x : place.component) largest = std::max(largest, std::abs(x));
  const Particles& p = simulation.particles();
  for (int k = 0; k < simulation.dimension(); ++k)
    for (std::size_t i = 0; i < p.size(); ++i) largest = std::max(largest, std::abs(p.position()[k][i]));
  const double rounding = std::numeric_limits<double>::epsilon() * largest;
  if (amplitude < least_share * rounding)
    throw Error(fmt::format(
        "{}: an amplitude of {:g} m is lost in the round-off of positions, {:.2g} m; give {:.2g} m or more, or "
        "use the method linear",
        start.spectrum.drive_place, amplitude, rounding, least_share * rounding));
}

void DrivenWalls::transfer(const StateTransfer& state) {
  const auto vectors = [&](const char* name, const char* unit, std::vector<Vec3>& all) {
    std::vector<double> numbers;
    for (const Vec3& v : all) numbers.insert(numbers.end(), {v[0], v[1], v[2]});
    state.rows(name, unit, numbers);
    if (numbers.size() % 3) state.refuse(name, "does not have three numbers for each wall");
    all.resize(numbers.size() / 3);
    for (std::size_t k = 0; k < all.size(); ++k)
      all[k] = {{numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]}};
  };
  vectors("motion", "1", motion_);
  vectors("at_rest", "m", at_rest_);
  state.value("square", "1", square_, stored::positive);
  state.value("prescribed", "", prescribed_);
}

void DrivenWalls::check_restored(const StateTransfer& state, std::size_t walls) const {
  if (motion_.size() != walls || at_rest_.size() != walls)
    state.refuse("at_rest", "or 'motion' does not have a vector for each wall");
}

}  // namespace scree::spectrum
