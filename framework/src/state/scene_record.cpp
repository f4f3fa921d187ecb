#include "state/group_record.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/branching.hpp>
#include <scree/error.hpp>
#include <scree/scene_record.hpp>
#include <scree/state_error.hpp>

namespace scree {

namespace {

constexpr const char* absent_line = "control = absent";

// Names, plug-ins and parameters of the laws, boundaries or body forces of a scene.
template <class Entries>
void save_plugins(const StateTransfer& state, const std::string& kind, const Entries& entries) {
  std::vector<std::string> names, plugins;
  for (const auto& entry : entries) {
    names.push_back(entry.name);
    plugins.push_back(entry.parameters.plugin().name);
    std::vector<std::string> lines = parameter_lines(entry.parameters);
    state.rows(fmt::format("{}_values_{}", kind, names.size() - 1), "", lines);
  }
  state.rows(kind + "_names", "", names);
  state.rows(kind + "_plugins", "", plugins);
}

std::vector<double> components(const std::vector<Body>& bodies, Vec3 Body::*vector) {
  std::vector<double> all(3 * bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (int k = 0; k < 3; ++k) all[3 * i + std::size_t(k)] = (bodies[i].*vector)[k];
  return all;
}

// Transfer one property of all bodies, which are const when saving.
template <class Bodies, class T>
void transfer_property(const StateTransfer& state, const char* name, const char* unit, Bodies& bodies,
                       T Body::*property) {
  std::vector<T> all(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) all[i] = bodies[i].*property;
  state.moved_rows(name, unit, all);
  if constexpr (!std::is_const_v<Bodies>)
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].*property = all[i];
}

template <class Bodies>
void transfer_vector(const StateTransfer& state, const char* name, const char* unit, Bodies& bodies,
                     Vec3 Body::*vector, bool always) {
  const auto is_zero = [&](const Body& body) { return body.*vector == Vec3{}; };
  if (!always && state.restoring() && !state.has(name)) return;
  if (!always && !state.restoring() && std::all_of(bodies.begin(), bodies.end(), is_zero)) return;
  std::vector<double> all = components(bodies, vector);
  state.moved_rows(name, unit, all, 3);
  if constexpr (!std::is_const_v<Bodies>)
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (int k = 0; k < 3; ++k) (bodies[i].*vector)[k] = all[3 * i + std::size_t(k)];
}

// Stored only if there are any.
template <class Bodies>
void transfer_held(const StateTransfer& state, Bodies& bodies) {
  const auto is_held = [](const Body& body) { return body.held != 0; };
  if (state.restoring() ? !state.has("held") : std::none_of(bodies.begin(), bodies.end(), is_held)) return;
  std::vector<freedom::Mask> all;
  for (const Body& body : bodies) all.push_back(body.held);
  state.moved_rows("held", "", all, 1, stored::at_most(freedom::all));
  if constexpr (!std::is_const_v<Bodies>)
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].held = all[i];
}
template <class Bodies>
void transfer_fixed(const StateTransfer& state, Bodies& bodies) {
  const auto is_fixed = [](const Body& body) { return body.fixed; };
  if (state.restoring() ? !state.has("fixed") : std::none_of(bodies.begin(), bodies.end(), is_fixed)) return;
  std::vector<std::uint8_t> all(bodies.size());
  std::transform(bodies.begin(), bodies.end(), all.begin(), is_fixed);
  state.moved_rows("fixed", "", all, 1, stored::usual<bool>());
  if constexpr (!std::is_const_v<Bodies>)
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].fixed = all[i] != 0;
}

template <class Bodies>
void transfer_bodies_at_start(const StateTransfer& state, Bodies& bodies) {
  const StateTransfer constant = state.below("bodies"), start = state.below("start");
  transfer_property(constant, "id", "", bodies, &Body::id);
  transfer_property(constant, "material", "", bodies, &Body::material);
  transfer_property(constant, "radius", "m", bodies, &Body::radius);
  transfer_property(constant, "mass", "kg", bodies, &Body::mass);
  transfer_property(constant, "inertia", "kg m^2", bodies, &Body::inertia);
  transfer_fixed(constant, bodies);
  transfer_held(constant, bodies);
  transfer_vector(start, "position", "m", bodies, &Body::position, true);
  transfer_vector(start, "velocity", "m/s", bodies, &Body::velocity, false);
  transfer_vector(start, "spin", "rad/s", bodies, &Body::spin, false);
}

// A line of a mesh has millions of numbers.
std::string shortened(const std::string& line) {
  constexpr std::size_t most = 200;
  return line.size() <= most ? line : line.substr(0, most) + " ...";
}
template <class T>
const T& shortened(const T& value) {
  return value;
}

// The first of the values in which two arrays differ, as text.
std::string difference(const StateArray& stored, const StateArray& present) {
  if (stored.values.index() != present.values.index()) return "another type of values";
  return std::visit(
      [&]<class T>(const std::vector<T>& before) {
        const auto& now = std::get<std::vector<T>>(present.values);
        const auto [x, y] = std::mismatch(before.begin(), before.end(), now.begin(), now.end());
        const auto text = [](auto at, const std::vector<T>& all) {
          return at == all.end() ? std::string("nothing more") : fmt::format("'{}'", shortened(*at));
        };
        return fmt::format("{} there, {} here", text(x, before), text(y, now));
      },
      stored.values);
}

}  // namespace

std::vector<std::string> parameter_lines(const Parameters& parameters) {
  std::vector<std::string> lines;
  const std::vector<scree_value> values = parameters.values();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto& [data, count] = values[k];
    if (count > 0)
      lines.push_back(
          fmt::format("{} = {}", parameters.plugin().parameters[k].key, fmt::join(data, data + count, ", ")));
  }
  if (parameters.absent()) lines.emplace_back(absent_line);
  return lines;
}

Parameters parameters_of(const scree_plugin& plugin, const std::vector<std::string>& lines) {
  Parameters parameters(plugin);
  const std::vector<std::string> defaults = parameter_lines(parameters);
  for (const std::string& line : lines) {
    // A default that is set would count as given, beside an alternative that excludes it.
    if (std::find(defaults.begin(), defaults.end(), line) != defaults.end()) continue;
    if (line == absent_line) {
      parameters.set_absent(true);
      continue;
    }
    parameters.set(line.substr(0, line.find(" = ")), numbers_of_line(line));
  }
  return parameters;
}

std::vector<double> numbers_of_line(const std::string& line) {
  std::vector<double> numbers;
  const char* at = line.data() + std::min(line.size(), line.find(" = ") + 3);
  for (const char* const end = line.data() + line.size(); at < end; at += 2) {
    const auto [rest, failed] = std::from_chars(at, end, numbers.emplace_back());
    if (failed != std::errc()) throw Error(fmt::format("'{}' in the state has no numbers", shortened(line)));
    at = rest;
  }
  return numbers;
}

void save_scene(const StateTransfer& state, const Scene& scene) {
  std::uint32_t interface = SCREE_ABI_VERSION;
  std::int32_t dimension = scene.dimension;
  double step = scene.step;
  std::string integrator = traits_of(scene.integration).name;
  bool mixed_precision = false, audit = scene.audit;
  std::vector<std::string> materials = scene.materials;
  std::vector<std::uint32_t> law_of = scene.law_of;
  state.value("plugin_interface", "", interface);
  state.value("dimension", "", dimension);
  state.value("step", "s", step);
  state.value("integrator", "", integrator);
  state.value("mixed_precision", "", mixed_precision);
  state.value("energy_audit", "", audit);
  state.rows("materials", "", materials);
  state.rows("law_of", "", law_of, std::max<std::size_t>(1, materials.size()));
  save_plugins(state, "law", scene.laws);
  save_plugins(state, "boundary", scene.boundaries);
  save_plugins(state, "body_force", scene.body_forces);
  save_groups(state, scene.groups);
}

namespace {

// What save_plugins has saved.
std::vector<RecordedPlugin> recorded_plugins(const State& state, const std::string& kind) {
  const StateTransfer scene = StateTransfer::restoring_from(state).below("scene");
  std::vector<std::string> names, plugins;
  scene.rows(kind + "_names", "", names);
  scene.rows(kind + "_plugins", "", plugins);
  if (plugins.size() != names.size())
    scene.refuse(kind + "_plugins", "does not have a plug-in for each " + kind);
  std::vector<RecordedPlugin> all;
  for (std::size_t k = 0; k < names.size(); ++k) {
    all.push_back({names[k], plugins[k], {}});
    scene.rows(fmt::format("{}_values_{}", kind, k), "", all.back().parameters);
  }
  return all;
}

constexpr std::string_view path_of_groups = "scene/group_";

State record_of(const Scene& scene) {
  State record;
  save_scene(StateTransfer::saving_to(record).below("scene"), scene);
  return record;
}

// Whether all that is recorded of a scene below a path is that of the state.
bool is_recorded(const State& state, const State& present, std::string_view below) {
  return std::all_of(present.arrays().begin(), present.arrays().end(), [&](const auto& entry) {
    return !entry.first.starts_with(below) ||
           (state.has(entry.first) && state.at(entry.first) == entry.second);
  });
}

}  // namespace

std::vector<RecordedPlugin> recorded_laws(const State& state) { return recorded_plugins(state, "law"); }
std::vector<RecordedPlugin> recorded_boundaries(const State& state) {
  return recorded_plugins(state, "boundary");
}
std::vector<RecordedPlugin> recorded_body_forces(const State& state) {
  return recorded_plugins(state, "body_force");
}

int dimension_of(const State& state) {
  std::int32_t dimension = 0;
  StateTransfer::restoring_from(state).value("scene/dimension", "", dimension, {.least = 2, .most = 3});
  return dimension;
}

std::vector<std::int64_t> recorded_ids(const State& state) {
  std::vector<std::int64_t> ids;
  StateTransfer::restoring_from(state).rows("bodies/id", "", ids);
  return ids;
}

bool is_scene_of(const State& state, const Scene& scene) {
  const State present = record_of(scene);
  // A state may have groups that the scene does not have.
  return is_recorded(state, present, "scene/") && is_recorded(present, state, path_of_groups);
}

bool has_laws_of(const State& state, const Scene& scene) {
  return is_recorded(state, record_of(scene), "scene/law_");
}

namespace {

// Earlier versions could evaluate contacts in single precision.
void refuse_mixed_precision(const State& state) {
  bool mixed = false;
  StateTransfer::restoring_from(state).value("scene/mixed_precision", "", mixed);
  if (mixed)
    throw StateError(
        "the state is of a run in mixed precision, which has been removed; begin a new run from it "
        "(particles.state)");
}

}  // namespace

void check_scene(const State& state, const Scene& scene) {
  refuse_mixed_precision(state);
  const State present = record_of(scene);
  for (const auto& [path, array] : present.arrays())
    if (const StateArray& stored = state.at(path); stored != array)
      throw StateError(
          fmt::format("'{}' is not that of this scene: {}; go on with the scenario of the state, or "
                      "begin a new run from it (particles.state)",
                      path, difference(stored, array)));
  if (!is_recorded(present, state, path_of_groups))
    throw StateError(
        "the groups of bodies are not those of this scene; go on with the scenario of the state");
}

void save_bodies_at_start(const StateTransfer& state, const Scene& scene) {
  transfer_bodies_at_start(state, scene.bodies);
  save_selections(state, scene.selections);
}

namespace {

bool is_finite(const Vec3& vector) {
  return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

// A simulation divides by masses and inertias, and finds laws by materials.
void check_bodies(const StateTransfer& state, const std::vector<Body>& bodies, std::size_t materials,
                  bool spinning) {
  const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
  for (const Body& body : bodies) {
    if (body.material >= materials) state.refuse("material", "has a material that the scene does not have");
    if (!positive(body.radius)) state.refuse("radius", "has a radius that is not above 0 m");
    if (!positive(body.mass)) state.refuse("mass", "has a mass that is not above 0 kg");
    if (spinning && !positive(body.inertia))
      state.refuse("inertia", "has a moment of inertia that is not above 0 kg m^2");
    if (!is_finite(body.position) || !is_finite(body.velocity) || !is_finite(body.spin))
      state.refuse("position", "has a body whose position, velocity or spin is not finite");
  }
}

}  // namespace

std::vector<Body> bodies_at_start(const State& state) {
  std::vector<Body> bodies(recorded_ids(state).size());
  const StateTransfer from = StateTransfer::restoring_from(state);
  transfer_bodies_at_start(from, bodies);
  check_bodies(from.below("bodies"), bodies, materials_of(state).size(), state.has("bodies/spin"));
  return bodies;
}

RecordedBodies recorded_bodies(const State& state) {
  return {bodies_at_start(state), groups_of(state), selections_of(state), recorded_boundaries(state)};
}

std::vector<Body> present_bodies(const State& state) {
  std::vector<Body> bodies = bodies_at_start(state);
  const StateTransfer present = StateTransfer::restoring_from(state).below("bodies");
  const bool spinning = state.has("bodies/spin");
  const std::size_t axes = std::size_t(dimension_of(state));
  const std::size_t spins = axes == 2 ? 1 : 3;
  std::vector<double> position(axes * bodies.size()), velocity(position),
      spin(spinning ? spins * bodies.size() : 0);
  present.sized_rows("position", "m", position, axes);
  present.sized_rows("velocity", "m/s", velocity, axes);
  if (spinning) present.sized_rows("spin", "rad/s", spin, spins);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].position = bodies[i].velocity = bodies[i].spin = {};
    for (std::size_t k = 0; k < axes; ++k) {
      bodies[i].position[int(k)] = position[axes * i + k];
      bodies[i].velocity[int(k)] = velocity[axes * i + k];
    }
    for (std::size_t k = 0; k < spins && spinning; ++k)
      bodies[i].spin[int(k + 3 - spins)] = spin[spins * i + k];
  }
  check_bodies(present, bodies, materials_of(state).size(), spinning);
  return bodies;
}

std::vector<std::string> materials_of(const State& state) {
  std::vector<std::string> names;
  StateTransfer::restoring_from(state).rows("scene/materials", "", names);
  return names;
}

Domain domain_of(const State& state) {
  Domain domain;
  const StateTransfer walls = StateTransfer::restoring_from(state).below("walls");
  walls.numbers("domain_lower", "m", domain.lower.component, 3);
  walls.numbers("domain_upper", "m", domain.upper.component, 3);
  for (int k = 0; k < 3; ++k) domain.periodic[std::size_t(k)] = domain.upper[k] > domain.lower[k];
  return domain;
}

double time_of(const State& state) {
  double time = 0;
  StateTransfer::restoring_from(state).value("clock/time", "s", time);
  return time;
}

}  // namespace scree
