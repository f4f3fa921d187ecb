#include "assembly/group_terms.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/plugin/program.hpp>

namespace scree::response {

namespace {

bool changes(const std::vector<double>& program) {
  return !program.empty() && Program::Kind(int(program[0])) != Program::constant;
}

bool moves(const Body& body, const Particles& p, std::size_t i) {
  for (int k = 0; k < 3; ++k)
    if ((p.is_held(i, k) && body.velocity[k] != 0) ||
        (p.is_held(i, freedom::first_rotation + k) && body.spin[k] != 0))
      return true;
  return false;
}

}  // namespace

void check_groups(const Simulation& simulation) {
  for (const BodyGroup& group : simulation.scene().groups) {
    if (any_given(group.velocity) || any_given(group.displacement))
      throw Error(
          fmt::format("group '{}' moves its bodies, and here supports are at rest; give it no function of "
                      "time, or drive a wall",
                      group.name));
    if (std::any_of(group.load.begin(), group.load.end(), changes))
      throw Error(
          fmt::format("group '{}' has a force or torque that is a function of time, and here loads are "
                      "constant; give it a number, or drive a wall",
                      group.name));
  }
  const Particles& p = simulation.particles();
  if (p.fixed.empty() && p.held.empty()) return;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (moves(simulation.scene().bodies[i], p, i))
      throw Error(
          fmt::format("particle {} is fixed and moves, and here supports are at rest; give its group no "
                      "velocity",
                      p.id[i]));
}

std::vector<freedom::Mask> held_components(const Particles& particles) {
  return {particles.held.begin(), particles.held.end()};
}

}  // namespace scree::response
