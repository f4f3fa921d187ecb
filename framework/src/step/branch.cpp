#include "step/branch.hpp"

#include "contacts/kernel/placement.hpp"
#include "contacts/stored_histories.hpp"
#include "surfaces/sliding_work.hpp"
#include "walls/enclosure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/scene_checks.hpp>
#include <scree/scene_record.hpp>

namespace scree {

namespace {

StateTransfer from(const State& state) { return StateTransfer::restoring_from(state); }
StateTransfer bodies_of(const State& state) { return from(state).below("bodies"); }

constexpr std::uint32_t no_wall = ~std::uint32_t(0);
// Relative, of springs and energies, which earlier versions could keep as float.
constexpr double single_precision = 1e-6;

// How much of an energy (J) is lost, and where it is found; nothing without an audit.
std::string energy_text(bool audit, double lost, double before, const char* column) {
  if (!audit) return "";
  return fmt::format(" ({:.3g} of {:.3g} J, in {} of the probe energy)", lost, before, column);
}

Error no_place(const std::string& what, const char* cure, const char* kind) {
  return Error(
      fmt::format("{}; {}, or leave {} out (particles.leave_out = [\"{}\"])", what, cure, kind, kind));
}

void check_bodies(const Scene& scene, const State& state) {
  const std::vector<std::int64_t> ids = recorded_ids(state);
  bool same = ids.size() <= scene.bodies.size();
  for (std::size_t i = 0; same && i < ids.size(); ++i) same = ids[i] == scene.bodies[i].id;
  const int dimension = dimension_of(state);
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
  const std::vector<RecordedPlugin> recorded = recorded_boundaries(state_);
  for (std::size_t k = 0; k < recorded.size(); ++k) {
    const auto& [name, plugin_name, lines] = recorded[k];
    const Boundaries::StoredWalls stored = Boundaries::stored_walls(state_, k);
    if (stored.planes + stored.surfaces == 0) continue;
    const auto found = std::find_if(
        scene_.boundaries.begin(), scene_.boundaries.end(),
        [&, &wanted = name](const Scene::Boundary& boundary) { return boundary.name == wanted; });
    if (found == scene_.boundaries.end())
      throw no_place(
          fmt::format("the state has the walls of '{}', and the scene has no boundary of this name", name),
          "add or rename one", "walls");
    const scree_plugin& plugin = found->parameters.plugin();
    if (plugin.name != plugin_name)
      throw no_place(fmt::format("the boundary '{}' is of the plug-in {} in the state and of {} in the scene",
                                 name, plugin_name, plugin.name),
                     "use the same", "walls");
    found->parameters = parameters_of(plugin, lines);
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
                             a.spin == b.spin && a.fixed == b.fixed && a.held == b.held;
                    });
}

}  // namespace

bool Branch::nothing_differs() const {
  // Functions of time of groups and body forces begin anew.
  return wanted_.groups.empty() && !varying_body_force(wanted_) && branching_.histories && branching_.walls &&
         branching_.orientations && is_scene_of(state_, wanted_) && has_bodies_of(state_, wanted_);
}

void Branch::take_over(Simulation& simulation, SimulationParts& parts) {
  const bool carried = (!wanted_.pair_forces || Forces::are_in(state_)) &&
                       (!parts.particles.orientations || Orientations::are_in(bodies_of(state_)));
  report_.push_back(counted(recorded_ids(state_).size(), "body", "bodies"));
  if (nothing_differs() && carried)
    take_over_all(parts);
  else
    take_over_by_name(simulation, parts);
  parts.lengths_at_start = enclosed_lengths(parts.boundaries, scene_.dimension);
}

void Branch::take_over_all(SimulationParts& parts) {
  parts.transfer(from(state_));
  parts.stepper.begin_anew();
  parts.boundaries.begin_anew();
  parts.body_forces.begin_anew();
  parts.audit = {};
  parts.momentum_audit = {};
  if (SlidingWork* const work = parts.forces.sliding_work()) work->clear();
  report_.emplace_back("everything else, since no law, wall or body force differs");
}

void Branch::take_over_by_name(Simulation& simulation, SimulationParts& parts) {
  take_over_orientations(parts);
  if (branching_.histories) take_over_images(parts);
  for (const Wall& wall : walls_) {
    parts.boundaries.take_over(state_, wall.from, wanted_.boundaries[wall.to].name);
    report_.push_back(fmt::format("walls of '{}'", wanted_.boundaries[wall.to].name));
  }
  parts.search_neighbours();
  if (branching_.histories)
    report_.push_back("histories of " + counted(take_over_histories(parts), "contact"));
  for (const Wall& wall : walls_) {
    const Scene::Boundary& wanted = wanted_.boundaries[wall.to];
    if (parameter_lines(wanted.parameters) != parameter_lines(scene_.boundaries[wall.to].parameters))
      simulation.reconfigure_boundary(wanted.name, wanted.parameters);
  }
  if (parts.boundaries.absent() != parts.neighbours.absent_at_search()) {
    parts.check_appeared_walls();
    parts.search_neighbours();
    // Without the contacts of walls that are absent now.
    if (branching_.histories)
      dropped_ = each_row(parts, [](PairGroup&, std::size_t, std::span<const double>) {});
  }
  parts.stepper.reevaluate_forces(0);
  count_lost(parts);
  // Evaluated without a motion, contacts at the limit of friction stick; they go on as they were.
  if (branching_.histories && has_laws_of(state_, wanted_)) take_over_histories(parts);
  // An integrator that evaluates forces at mid-step has left them half a step behind.
  if (const double behind = Stepper::forces_behind(state_); behind != 0)
    parts.stepper.reevaluate_forces(behind);
}

void Branch::take_over_orientations(SimulationParts& parts) {
  if (!parts.particles.orientations || !branching_.orientations || !Orientations::are_in(bodies_of(state_)))
    return;
  parts.particles.orientations.transfer(bodies_of(state_), recorded_ids(state_).size());
  report_.emplace_back("orientations");
}

void Branch::take_over_images(SimulationParts& parts) const {
  const bool follow = std::any_of(parts.laws.begin(), parts.laws.end(),
                                  [](const LawInstance& law) { return kernel::reads_paths(law.interface); });
  const StateTransfer bodies = bodies_of(state_),
                      walls = StateTransfer::restoring_from(state_).below("walls");
  if (!follow || !bodies.has("image") || parts.particles.image[0].empty()) return;
  const Domain& domain = parts.boundaries.domain();
  Vec3 lower = {}, upper = {};
  walls.numbers("domain_lower", "m", lower.component, 3);
  walls.numbers("domain_upper", "m", upper.component, 3);
  if (lower != domain.lower || upper != domain.upper) return;
  // Bodies of the state come first.
  const auto width = std::size_t(scene_.dimension);
  std::vector<std::int32_t> images(recorded_ids(state_).size() * width);
  bodies.sized_rows("image", "1", images, width);
  for (std::size_t i = 0; i < images.size(); ++i) parts.particles.image[i % width][i / width] = images[i];
}

std::vector<std::uint32_t> Branch::walls_here(const SimulationParts& parts) const {
  const std::size_t planes = Boundaries::plane_count(state_);
  std::vector<std::uint32_t> here(planes + Boundaries::surface_count(state_), no_wall);
  const auto set = [&](std::size_t first, std::size_t count, std::size_t first_here) {
    for (std::size_t k = 0; k < count && first + k < here.size(); ++k)
      here[first + k] = std::uint32_t(first_here + k);
  };
  for (const Wall& wall : walls_) {
    const Boundaries::StoredWalls stored = Boundaries::stored_walls(state_, wall.from);
    set(stored.first_plane, stored.planes, parts.boundaries.first_plane(wall.to));
    set(planes + stored.first_surface, stored.surfaces,
        parts.boundaries.planes().size() + parts.boundaries.first_surface(wall.to));
  }
  return here;
}

namespace {

// Whether a body does not touch what it touches in the state, since the wall or the law is absent.
bool is_absent(const SimulationParts& parts, bool wall, std::uint32_t a, std::uint32_t b) {
  const Boundaries& boundaries = parts.boundaries;
  if (wall && boundaries.absent()[b]) return true;
  const Scene& scene = parts.scene;
  const std::uint32_t other = wall ? boundaries.wall_materials()[b] : scene.bodies[b].material;
  const std::size_t pair = scene.bodies[a].material * scene.materials.size() + other;
  return scene.laws[scene.law_of[pair]].parameters.absent();
}

}  // namespace

std::size_t Branch::take_over_histories(SimulationParts& parts) {
  std::size_t taken = 0;
  dropped_ = each_row(parts, [&](PairGroup& group, std::size_t row, std::span<const double> numbers) {
    for (std::uint32_t k = 0; k < group.history_width; ++k) group.history.column(k)[row] = numbers[k];
    ++taken;
  });
  return taken;
}

Branch::Dropped Branch::each_row(SimulationParts& parts, const VisitRow& visit) const {
  const std::vector<std::uint32_t> walls = walls_here(parts);
  Dropped dropped;
  each_history(state_, [&](const StoredHistory& stored) {
    if (!branching_.histories) return void(++dropped.asked);
    const std::uint32_t b = !stored.plane ? stored.b : stored.b < walls.size() ? walls[stored.b] : no_wall;
    if (b == no_wall) return void(++dropped.of_walls);
    if (!stored.plane && scene_.bodies[stored.a].fixed && scene_.bodies[b].fixed)
      return void(++dropped.of_fixed);
    const auto [group, row] =
        parts.contacts.find(stored.plane, stored.a, b, parts.particles.order(), stored.spot);
    if (!group && is_absent(parts, stored.plane, stored.a, b)) return void(++dropped.of_absent);
    if (!group)
      throw no_place("two bodies touch in the state and not in the scene", "keep its periodic faces",
                     "histories");
    const std::string law = wanted_.laws[group->law].parameters.plugin().name;
    if (law != stored.plugin)
      throw no_place(
          fmt::format("contacts have histories of the law {} in the state and are of the law {} in the scene",
                      stored.plugin, law),
          "use the same law", "histories");
    if (group->history_width != stored.numbers.size()) return void(++dropped.of_laws);
    visit(*group, row, stored.numbers);
  });
  return dropped;
}

void Branch::count_lost(SimulationParts& parts) {
  const double lost = parts.contact_sums.dissipated_friction + parts.contact_sums.dissipated_release;
  const bool same_laws = has_laws_of(state_, wanted_);
  if (!branching_.histories) dropped_ = each_row(parts, {});
  if (!same_laws) parts.audit.add_lost(parts.contact_sums);
  const ContactSums before = SimulationParts::contact_sums_in(state_);
  if (!same_laws && branching_.histories) report_cut(parts, lost, before.elastic_tangential);
  const auto missing = [](double then, double now) {
    return then - now > single_precision * then ? then - now : 0;
  };
  double released = 0;
  if (dropped_.all() > 0)
    released +=
        missing(before.elastic_tangential, parts.contact_sums.elastic_tangential + (same_laws ? 0 : lost));
  // Other laws store another energy.
  const bool walls_left =
      !branching_.walls && Boundaries::plane_count(state_) + Boundaries::surface_count(state_) > 0;
  if (same_laws && (walls_left || dropped_.of_fixed > 0 || dropped_.of_absent > 0))
    released += missing(before.elastic_normal, parts.contact_sums.elastic_normal);
  parts.audit.add_released(released);
  report_dropped(released, before.elastic_normal + before.elastic_tangential);
}

void Branch::report_cut(SimulationParts& parts, double lost, double before) {
  std::size_t cut = 0, all = 0;
  each_row(parts, [&](PairGroup& group, std::size_t row, std::span<const double> numbers) {
    const std::int32_t sliding = parts.laws[group.law].interface.sliding_column;
    double largest = 0, change = 0;
    for (std::uint32_t k = 0; k < group.history_width; ++k) {
      if (std::int32_t(k) == sliding) continue;
      largest = std::max(largest, std::abs(numbers[k]));
      change = std::max(change, std::abs(group.history.column(k)[row] - numbers[k]));
    }
    cut += change > single_precision * largest;
    ++all;
  });
  if (cut == 0 || (parts.scene.audit && !(lost > 0))) return;
  let_go_.push_back(fmt::format(
      "the laws of the scene cut the springs of {} of {} contacts of the state{}; give them the friction and "
      "stiffness of the state, and others in a later stage, if the springs are to last",
      cut, all, energy_text(parts.scene.audit, lost, before, "dissipated_friction")));
}

void Branch::report_dropped(double energy, double before) {
  const std::string lost = energy_text(wanted_.audit, energy, before, "dissipated_release");
  const auto add = [&](std::size_t contacts, const char* why, const char* cure) {
    if (contacts > 0)
      let_go_.push_back(
          fmt::format("{} contacts lose the springs that they have in the state, since {}{}; {}", contacts,
                      why, lost, cure));
  };
  add(dropped_.asked, "histories are left out", "remove \"histories\" from particles.leave_out to keep them");
  add(dropped_.of_walls, "their walls are left out",
      "remove \"walls\" from particles.leave_out to keep them");
  add(dropped_.of_fixed, "both of their bodies are fixed", "leave one of them free to keep them");
  add(dropped_.of_absent, "their wall or law is absent", "let it be there in the first stage to keep them");
  add(dropped_.of_laws, "their law keeps other numbers with its present parameters",
      "give it the parameters of the state to keep them");
  if (dropped_.all() == 0 && energy > 0)
    let_go_.push_back(
        fmt::format("contacts with walls of the state that are left out no longer bear load{}; remove "
                    "\"walls\" from particles.leave_out to keep them",
                    lost));
}

}  // namespace scree
