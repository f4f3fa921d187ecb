#include "step/branch.hpp"

#include "contacts/stored_histories.hpp"
#include "plugins/enclosure.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/scene_record.hpp>

namespace scree {

namespace {

StateTransfer from(const State& state) { return StateTransfer::restoring_from(state); }

template <class T>
const std::vector<T>& numbers_at(const State& state, const std::string& path) {
  const auto* numbers = std::get_if<std::vector<T>>(&state.at(path).values);
  if (!numbers)
    throw Error(fmt::format("'{}' has another type of values; take a state of this version", path));
  return *numbers;
}

constexpr std::uint32_t no_plane = ~std::uint32_t(0);

Error no_place(const std::string& what, const char* cure, const char* kind) {
  return Error(
      fmt::format("{}; {}, or leave {} out (particles.leave_out = [\"{}\"])", what, cure, kind, kind));
}

void check_bodies(const Scene& scene, const State& state) {
  const auto& ids = numbers_at<std::int64_t>(state, "bodies/id");
  bool same = ids.size() <= scene.bodies.size();
  for (std::size_t i = 0; same && i < ids.size(); ++i) same = ids[i] == scene.bodies[i].id;
  std::int32_t dimension = 0;
  from(state).value("scene/dimension", "", dimension);
  if (dimension != scene.dimension)
    throw Error(fmt::format("the state has {} dimensions and the scene {}; set scene.dimension = {}",
                            dimension, scene.dimension, dimension));
  if (!same)
    throw Error("the first bodies of the scene are not those of the state; take its bodies in their order");
}

}  // namespace

Branch::Branch(const Scene& scene, const State& state, const Branching& branching)
    : wanted_(scene), state_(state), branching_(branching), scene_(scene) {
  check_bodies(scene, state);
  if (branching.walls) match_walls();
}

void Branch::match_walls() {
  const auto& names = numbers_at<std::string>(state_, "scene/boundary_names");
  const auto& plugins = numbers_at<std::string>(state_, "scene/boundary_plugins");
  if (plugins.size() != names.size())
    from(state_).refuse("scene/boundary_plugins", "does not have a plug-in for each boundary");
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::uint64_t planes = 0;
    from(state_).value(fmt::format("walls/{}/plane_count", k), "1", planes);
    if (planes == 0) continue;
    const auto found =
        std::find_if(scene_.boundaries.begin(), scene_.boundaries.end(),
                     [&](const Scene::Boundary& boundary) { return boundary.name == names[k]; });
    if (found == scene_.boundaries.end())
      throw no_place(
          fmt::format("the state has the walls of '{}', and the scene has no boundary of this name",
                      names[k]),
          "add or rename one", "walls");
    const scree_plugin& plugin = found->parameters.plugin();
    if (plugin.name != plugins[k])
      throw no_place(fmt::format("the boundary '{}' is of the plug-in {} in the state and of {} in the scene",
                                 names[k], plugins[k], plugin.name),
                     "use the same", "walls");
    found->parameters =
        parameters_of(plugin, numbers_at<std::string>(state_, fmt::format("scene/boundary_values_{}", k)));
    walls_.push_back({k, std::size_t(found - scene_.boundaries.begin())});
  }
}

namespace {

// Whether a scene has the bodies of a state as they are there: it may have given them other velocities.
bool has_bodies_of(const State& state, const Scene& scene) {
  const std::vector<Body> present = present_bodies(state);
  return std::equal(present.begin(), present.end(), scene.bodies.begin(), scene.bodies.end(),
                    [](const Body& a, const Body& b) {
                      return a.material == b.material && a.radius == b.radius && a.mass == b.mass &&
                             a.inertia == b.inertia && a.position == b.position && a.velocity == b.velocity &&
                             a.spin == b.spin;
                    });
}

}  // namespace

bool Branch::nothing_differs() const {
  return branching_.histories && branching_.walls && branching_.orientations &&
         is_scene_of(state_, wanted_) && has_bodies_of(state_, wanted_);
}

void Branch::take_over(Simulation& simulation, SimulationParts& parts) {
  const bool carried = (!wanted_.pair_forces || state_.has("contacts/force_row")) &&
                       (!parts.particles.orientations || state_.has("bodies/orientation"));
  report_.push_back(fmt::format("{} bodies", state_.at("bodies/id").size()));
  if (nothing_differs() && carried)
    take_over_all(parts);
  else
    take_over_by_name(simulation, parts);
  parts.lengths_at_start =
      enclosed_lengths(parts.boundaries.planes(), parts.boundaries.domain(), scene_.dimension);
}

void Branch::take_over_all(SimulationParts& parts) {
  parts.transfer(from(state_));
  parts.stepper.begin_anew();
  parts.boundaries.begin_anew();
  parts.audit = {};
  parts.momentum_audit = {};
  report_.emplace_back("everything else, since no law, wall or body force differs");
}

void Branch::take_over_by_name(Simulation& simulation, SimulationParts& parts) {
  take_over_orientations(parts);
  for (const Wall& wall : walls_) {
    parts.boundaries.take_over(state_, wall.from, wanted_.boundaries[wall.to].name);
    report_.push_back(fmt::format("walls of '{}'", wanted_.boundaries[wall.to].name));
  }
  parts.search_neighbours();
  if (branching_.histories)
    report_.push_back(fmt::format("histories of {} contacts", take_over_histories(parts)));
  for (const Wall& wall : walls_) {
    const Scene::Boundary& wanted = wanted_.boundaries[wall.to];
    if (parameter_lines(wanted.parameters) != parameter_lines(scene_.boundaries[wall.to].parameters))
      simulation.reconfigure_boundary(wanted.name, wanted.parameters);
  }
  // An integrator that evaluates forces at mid-step has left them half a step behind.
  double time = 0, force_time = 0;
  from(state_).value("clock/time", "s", time);
  from(state_).value("clock/force_time", "s", force_time);
  parts.stepper.reevaluate_forces(time - force_time);
  // Evaluated without a motion, contacts at the limit of friction stick; they go on as they were.
  if (branching_.histories && time == force_time && has_laws_of(state_, wanted_)) take_over_histories(parts);
}

void Branch::take_over_orientations(SimulationParts& parts) {
  if (!parts.particles.orientations || !branching_.orientations || !state_.has("bodies/orientation")) return;
  parts.particles.orientations.transfer(from(state_).below("bodies"), state_.at("bodies/id").size());
  report_.emplace_back("orientations");
}

std::vector<std::uint32_t> Branch::planes_here(const SimulationParts& parts) const {
  std::vector<std::uint32_t> here(state_.at("walls/planes/point").size() / 3, no_plane);
  for (const Wall& wall : walls_) {
    std::uint64_t first = 0, count = 0;
    from(state_).value(fmt::format("walls/{}/first_plane", wall.from), "", first);
    from(state_).value(fmt::format("walls/{}/plane_count", wall.from), "1", count);
    for (std::size_t k = 0; k < count && first + k < here.size(); ++k)
      here[first + k] = std::uint32_t(parts.boundaries.first_plane(wall.to) + k);
  }
  return here;
}

std::size_t Branch::take_over_histories(SimulationParts& parts) {
  const std::vector<std::uint32_t> planes = planes_here(parts);
  std::size_t taken = 0;
  each_history(state_, [&](const StoredHistory& stored) {
    const std::uint32_t b = !stored.plane ? stored.b : stored.b < planes.size() ? planes[stored.b] : no_plane;
    if (b == no_plane) return;
    const auto [group, row] = parts.contacts.find(stored.plane, stored.a, b);
    if (!group)
      throw no_place("two bodies touch in the state and not in the scene", "keep its periodic faces",
                     "histories");
    const Parameters& law = wanted_.laws[group->law].parameters;
    if (law.plugin().name != stored.plugin || group->history_width != stored.numbers.size())
      throw no_place(
          fmt::format("contacts have histories of the law {} in the state and the law {} in the scene, with "
                      "{} and {} numbers",
                      stored.plugin, law.plugin().name, stored.numbers.size(), group->history_width),
          "use the same law", "histories");
    for (std::uint32_t k = 0; k < group->history_width; ++k) group->history.set(k, row, stored.numbers[k]);
    ++taken;
  });
  return taken;
}

}  // namespace scree
