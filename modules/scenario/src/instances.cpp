#include "readers.hpp"

#include <algorithm>
#include <iterator>

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
  read_parameters(table, scene.dimension, parameters);
  check_complete(table, parameters);
  const std::string name = instances.names.add_or_number(table, parameters.plugin().name);
  const Stage::Change& added = instances.all.emplace_back(Stage::Change{kind, name, parameters});
  placed(table, "plugin", [&] { check_instance(added, scene); });
  return added;
}

Stage::Change changed_instance(const document::Table& table, const Stage::Change& old, const Scene& scene) {
  for (const std::string& key : table.keys())
    if (const scree_parameter* p = old.parameters.find(key); p && (p->flags & SCREE_AT_START_ONLY))
      throw table.error(key, fmt::format("'{}' describes the start, and a stage cannot change it", key),
                        fmt::format("set it where '{}' is declared", old.name));
  Stage::Change changed = old;
  read_parameters(table, scene.dimension, changed.parameters);
  check_complete(table, changed.parameters);
  placed(table, "", [&] { check_instance(changed, scene); });
  if (old.kind == SCREE_BOUNDARY && !same_layout(configured_boundary(old.parameters, scene),
                                                 configured_boundary(changed.parameters, scene)))
    throw table.error("a stage cannot change the number of walls or the periodic axes",
                      "keep these parameters for all stages");
  return changed;
}

}  // namespace scree::scenario
