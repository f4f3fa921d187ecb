#include "readers.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include <scree/body_bounds.hpp>
#include <scree/scene_checks.hpp>

namespace scree::scenario {

namespace {

scree_boundary_instance configured_boundary(const Parameters& parameters, const Scene& scene) {
  const BodyBounds box = bounds_of(scene.bodies, scene.dimension);
  const double lower[3] = {box.lower[0], box.lower[1], box.lower[2]};
  const double upper[3] = {box.upper[0], box.upper[1], box.upper[2]};
  return ConfiguredBoundary(parameters, scene.dimension, lower, upper).instance();
}

// Configures the plug-in once, so that it can reject its parameters while the position in the file is known.
void check_instance(const Stage::Change& instance, const Scene& scene) {
  switch (instance.kind) {
    case SCREE_CONTACT_LAW:
      exerts_torque(instance.parameters, scene.dimension);
      break;
    case SCREE_BOUNDARY:
      configured_boundary(instance.parameters, scene);
      break;
    case SCREE_BODY_FORCE:
      check_body_force({instance.name, instance.parameters}, scene);
      break;
    case SCREE_PROBE:
      break;
  }
}

// Walls and periodic axes are set up once per simulation and cannot change later.
bool same_layout(const scree_boundary_instance& a, const scree_boundary_instance& b) {
  const auto same_axis = [&](int k) {
    return a.periodic[k] == b.periodic[k] &&
           (!a.periodic[k] || (a.lower[k] == b.lower[k] && a.upper[k] == b.upper[k]));
  };
  return a.plane_count == b.plane_count && same_axis(0) && same_axis(1) && same_axis(2);
}

}  // namespace

const Stage::Change& read_instance(const document::Table& table, scree_kind kind, PluginHost& host,
                                   const Scene& scene, Instances& instances) {
  Parameters parameters(find_plugin(table, kind, host));
  // First, since the law that the user then chooses has other parameters.
  if (kind == SCREE_CONTACT_LAW)
    placed(table, "plugin", [&] { check_dimension(parameters, scene.dimension); });
  read_parameters(table, scene.dimension, instances.read_mesh, parameters);
  check_complete(table, parameters);
  const std::string name = instances.names.add_or_number(table, parameters.plugin().name);
  const Stage::Change& added = instances.all.emplace_back(Stage::Change{kind, name, parameters});
  placed(table, "plugin", [&] { check_instance(added, scene); });
  return added;
}

namespace {

// Whether a key is a part of a more general one: stress_x_low and stress_x of stress, z_low of z.
bool is_part_of(std::string_view key, std::string_view general) {
  if (!key.starts_with(general) || key == general) return false;
  constexpr std::string_view parts[] = {"_x",      "_y",     "_z",      "_low",   "_high",  "_x_low",
                                        "_x_high", "_y_low", "_y_high", "_z_low", "_z_high"};
  return std::find(std::begin(parts), std::end(parts), key.substr(general.size())) != std::end(parts);
}

// Keys given before that a table of a stage replaces by others: what a key excludes, and the parts of a key.
std::set<std::string> replaced_keys(const document::Table& table, const Parameters& before) {
  const scree_plugin& plugin = before.plugin();
  const std::span declared(plugin.parameters, plugin.parameter_count);
  std::set<std::string> replaced;
  for (const scree_parameter& set : declared) {
    if (!table.has(set.key)) continue;
    for (const scree_parameter& other : declared) {
      const bool excluded = (set.excludes && std::string_view(set.excludes) == other.key) ||
                            (other.excludes && std::string_view(other.excludes) == set.key);
      if ((excluded || is_part_of(other.key, set.key)) && before.given(other.key) && !table.has(other.key))
        replaced.insert(other.key);
    }
  }
  return replaced;
}

// Of a wall whose axis had the control before: "z_high" in the table makes the control z of the axis that of
// both walls, of which the table then changes one.
std::map<std::string, std::string> split_controls(const document::Table& table, const Parameters& before) {
  std::map<std::string, std::string> general_of;  // by the key of a wall
  const scree_plugin& plugin = before.plugin();
  for (const scree_parameter& axis : std::span(plugin.parameters, plugin.parameter_count)) {
    if (axis.type != SCREE_CHOICE || !before.given(axis.key) || table.has(axis.key)) continue;
    const std::string low = std::string(axis.key) + "_low", high = std::string(axis.key) + "_high";
    if (!before.find(low) || !before.find(high) || (!table.has(low) && !table.has(high))) continue;
    general_of[low] = axis.key;
    general_of[high] = axis.key;
  }
  return general_of;
}

// The parameters without what a table of a stage replaces.
Parameters kept_parameters(const document::Table& table, const Parameters& before) {
  const std::set<std::string> replaced = replaced_keys(table, before);
  const std::map<std::string, std::string> general_of = split_controls(table, before);
  if (replaced.empty() && general_of.empty()) return before;
  Parameters kept(before.plugin());
  kept.set_absent(before.absent());
  const std::vector<scree_value> values = before.values();
  std::map<std::string, std::vector<double>> numbers;
  for (std::uint32_t k = 0; k < before.plugin().parameter_count; ++k) {
    const std::string key = before.plugin().parameters[k].key;
    if (before.given(key) && !replaced.contains(key))
      numbers[key] = {values[k].data, values[k].data + values[k].count};
  }
  for (const auto& [wall, axis] : general_of)
    if (const auto control = numbers.find(axis); control != numbers.end()) numbers[wall] = control->second;
  for (const auto& [wall, axis] : general_of) numbers.erase(axis);
  for (auto& [key, data] : numbers) kept.set(key, std::move(data));
  return kept;
}

}  // namespace

Stage::Change changed_instance(const document::Table& table, const Stage::Change& old, const Scene& scene) {
  for (const std::string& key : table.keys())
    if (const scree_parameter* p = old.parameters.find(key); p && (p->flags & SCREE_AT_START_ONLY))
      throw table.error(key, fmt::format("'{}' describes the start, and a stage cannot change it", key),
                        fmt::format("set it where '{}' is declared", old.name));
  Stage::Change changed = old;
  changed.parameters = kept_parameters(table, old.parameters);
  read_parameters(table, scene.dimension, no_mesh, changed.parameters);
  check_complete(table, changed.parameters);
  placed(table, "", [&] { check_instance(changed, scene); });
  if (old.kind == SCREE_BOUNDARY && !same_layout(configured_boundary(old.parameters, scene),
                                                 configured_boundary(changed.parameters, scene)))
    throw table.error("a stage cannot change the number of walls or the periodic axes",
                      "keep these parameters for all stages");
  return changed;
}

}  // namespace scree::scenario
