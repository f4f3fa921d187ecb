#include "equilibrium/static_state.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include <scree/state_hash.hpp>
#include <scree/state_transfer.hpp>

namespace scree::response {

namespace {

Vectors<double> vectors_of(std::vector<Vec3>& all, std::size_t first, std::size_t count) {
  return {count > 0 ? all[first].component : nullptr, 3, count, 0, 3};
}

// Positions within the periods in which the simulation has its bodies.
std::vector<Vec3> folded(const Simulation& simulation, const StaticConfiguration& at) {
  const Particles& p = simulation.particles();
  std::vector<Vec3> positions = at.position;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < p.dimension(); ++k)
      if (!p.image[k].empty()) positions[i][k] -= p.image[k][i] * simulation.domain().length(k);
  return positions;
}

void save_bodies(const StateTransfer& state, const Simulation& simulation, const StaticConfiguration& at) {
  const Particles& p = simulation.particles();
  const std::size_t bodies = p.size();
  std::vector<Vec3> positions = folded(simulation, at), nothing(bodies, Vec3{});
  const Vectors<double> zeros = vectors_of(nothing, 0, bodies);
  const int D = p.dimension();
  state.vectors("position", "m", vectors_of(positions, 0, bodies), 0, D);
  for (const auto& [name, unit] :
       {std::pair{"velocity", "m/s"}, std::pair{"mid_velocity", "m/s"}, std::pair{"force", "N"}})
    state.vectors(name, unit, zeros, 0, D);
  if (p.has_spin())
    for (const auto& [name, unit] :
         {std::pair{"spin", "rad/s"}, std::pair{"mid_spin", "rad/s"}, std::pair{"torque", "N m"}})
      state.vectors(name, unit, zeros, p.spin_axes().first, p.spin_axes().last);
  if (at.orientations) Orientations(at.orientations).transfer(state, bodies);
}

void save_walls(const StateTransfer& state, const Simulation& simulation, const StaticConfiguration& at,
                const StaticLoads& loads) {
  const std::size_t bodies = simulation.particles().size(), walls = simulation.planes().size();
  std::vector<Vec3> points = at.position, forces = loads.force, nothing(walls, Vec3{});
  state.vectors("planes/point", "m", vectors_of(points, bodies, walls), 0, 3);
  state.vectors("planes/velocity", "m/s", vectors_of(nothing, 0, walls), 0, 3);
  state.vectors("planes/mid_velocity", "m/s", vectors_of(nothing, 0, walls), 0, 3);
  state.vectors("load", "N", vectors_of(forces, bodies, walls), 0, 3);
}

// As Domain::shift.
std::uint8_t image_of(const Domain& domain, const Vec3& apart) {
  int code = 0;
  for (int k = 2; k >= 0; --k)
    code =
        3 * code + 1 - (domain.periodic[std::size_t(k)] ? int(std::lround(apart[k] / domain.length(k))) : 0);
  return std::uint8_t(code);
}

// The contacts of a law with bodies, or with walls.
void save_group(const StateTransfer& state, const Simulation& simulation, const std::vector<Vec3>& positions,
                std::vector<TouchingPair> contacts) {
  const std::size_t bodies = simulation.particles().size();
  std::sort(contacts.begin(), contacts.end(),
            [](const auto& a, const auto& b) { return std::tie(a.a, a.b) < std::tie(b.a, b.b); });
  std::vector<std::uint32_t> a, b, rows;
  std::vector<std::uint8_t> images;
  std::vector<double> histories;
  for (const TouchingPair& c : contacts) {
    const bool wall = c.b >= bodies;
    rows.push_back(std::uint32_t(a.size()));
    a.push_back(c.a);
    b.push_back(wall ? std::uint32_t(c.b - bodies) : c.b);
    images.push_back(wall ? Domain::no_shift
                          : image_of(simulation.domain(), positions[c.a] - positions[c.b]));
    histories.insert(histories.end(), c.history, c.history + c.width);
  }
  const std::size_t width = contacts.empty() ? 0 : contacts[0].width;
  state.moved_rows("a", "", a);
  state.moved_rows("b", "", b);
  state.moved_rows("image", "", images);
  if (width == 0) return;
  state.moved_rows("history_row", "", rows);
  state.moved_rows("history", "1", histories, width);
}

void save_contacts(State& all, const Simulation& simulation, const std::vector<Vec3>& positions,
                   const std::vector<TouchingPair>& contacts) {
  const std::size_t bodies = simulation.particles().size();
  for (std::size_t g = 0; all.has(fmt::format("contacts/{}/law", g)); ++g) {
    const StateTransfer stored = StateTransfer::restoring_from(all).below(fmt::format("contacts/{}", g));
    std::uint32_t law = 0;
    bool planes = false;
    stored.value("law", "", law);
    stored.value("planes", "", planes);
    std::vector<TouchingPair> group;
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(group),
                 [&](const auto& c) { return c.law == law && (c.b >= bodies) == planes; });
    save_group(StateTransfer::saving_to(all).below(fmt::format("contacts/{}", g)), simulation, positions,
               std::move(group));
  }
  // Forces of contacts are known after the next step.
  if (!all.has("contacts/force_row")) return;
  all.put("contacts/force_row", {std::vector<std::uint32_t>{}, {0}, ""});
  all.put("contacts/force", {std::vector<double>{}, {0, 3}, "N"});
}

}  // namespace

State static_state(const Simulation& simulation, double time, const StaticConfiguration& at,
                   const std::vector<TouchingPair>& contacts, const StaticLoads& loads) {
  State state = simulation.state();
  const StateTransfer saving = StateTransfer::saving_to(state);
  save_bodies(saving.below("bodies"), simulation, at);
  save_walls(saving.below("walls"), simulation, at, loads);
  save_contacts(state, simulation, folded(simulation, at), contacts);
  auto steps = std::uint64_t(std::llround(time / simulation.step_length()));
  double now = double(steps) * simulation.step_length();
  saving.value("clock/time", "s", now);
  saving.value("clock/steps", "1", steps);
  saving.value("clock/force_time", "s", now);
  std::uint64_t hash = StateHash::unknown;
  saving.value("state_hash", "", hash);
  // More than any skin, so that neighbours are searched for in the next step.
  double travel = 1e3 * simulation.skin();
  saving.value("neighbours/body_travel", "m", travel);
  return state;
}

}  // namespace scree::response
