#include "group_keys.hpp"
#include "output_keys.hpp"
#include "readers.hpp"

#include <algorithm>
#include <functional>
#include <unordered_set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>

namespace scree::scenario {

namespace {

// The bodies of a group. Each condition of `where` leaves out those that do not meet it.
class Selection {
 public:
  explicit Selection(const Scene& scene) : scene_(scene), chosen_(scene.bodies.size(), true) {}

  void keep_if(const std::function<bool(const Body&)>& meets) {
    for (std::size_t i = 0; i < chosen_.size(); ++i) chosen_[i] = chosen_[i] && meets(scene_.bodies[i]);
    ++conditions_;
  }
  std::size_t conditions() const { return conditions_; }
  std::vector<std::uint32_t> bodies() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < chosen_.size(); ++i)
      if (chosen_[i]) all.push_back(i);
    return all;
  }

 private:
  const Scene& scene_;
  std::vector<bool> chosen_;
  std::size_t conditions_ = 0;
};

void keep_ids(const document::Table& where, const Scene& scene, Selection& selection) {
  if (!where.optional(group_where_keys.ids)) return;
  const std::vector<std::int64_t> ids = where.integers(group_where_keys.ids);
  std::unordered_set<std::int64_t> known;
  for (const Body& body : scene.bodies) known.insert(body.id);
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (!known.contains(ids[k]))
      throw where.error(group_where_keys.ids, k, fmt::format("no body has the id {}", ids[k]),
                        "give ids of bodies, as [[particle]], a file or a probe has them");
  const std::unordered_set<std::int64_t> wanted(ids.begin(), ids.end());
  selection.keep_if([&](const Body& body) { return wanted.contains(body.id); });
}

void keep_particles(const document::Table& where, const std::vector<BodySource>& sources,
                    Selection& selection) {
  const auto name = where.optional_string(group_where_keys.particles);
  if (!name) return;
  std::vector<std::string> names;
  for (const BodySource& source : sources) names.push_back(source.name);
  const BodySource& source =
      sources[find_name(where, group_where_keys.particles, "[[particles]]", *name, names)];
  selection.keep_if([&source](const Body& body) {
    return std::any_of(source.ids.begin(), source.ids.end(),
                       [&](const IdRange& range) { return range.first <= body.id && body.id <= range.last; });
  });
}

void keep_material(const document::Table& where, const Scene& scene, Selection& selection) {
  const auto name = where.optional_string(group_where_keys.material);
  if (!name) return;
  const std::size_t material =
      find_name(where, group_where_keys.material, "material", *name, scene.materials);
  selection.keep_if([&](const Body& body) { return body.material == material; });
}

void keep_ranges(const document::Table& where, int dimension, Selection& selection) {
  const Key* const axes[] = {&group_where_keys.x, &group_where_keys.y, &group_where_keys.z};
  for (int k = 0; k < 3; ++k) {
    const Key& axis = *axes[k];
    if (!where.optional(axis)) continue;
    if (k >= dimension)
      throw where.error(axis, "a scene of two dimensions has no z", "remove it, or set scene.dimension = 3");
    const std::vector<double> range = where.numbers(axis, 2);
    if (!(range[0] <= range[1]))
      throw where.error(axis, fmt::format("{:g} is above {:g} m", range[0], range[1]),
                        "give the lower end first");
    selection.keep_if(
        [&](const Body& body) { return body.position[k] >= range[0] && body.position[k] <= range[1]; });
  }
}

void keep_sphere(const document::Table& where, int dimension, Selection& selection) {
  const auto sphere = where.optional_table(group_where_keys.sphere);
  if (!sphere) return;
  const Vec3 centre = read_vector(*sphere, sphere_keys.centre, dimension, true);
  const double radius = read(*sphere, sphere_keys.radius);
  selection.keep_if([&](const Body& body) { return norm(body.position - centre) <= radius; });
}

void keep_cylinder(const document::Table& where, int dimension, Selection& selection) {
  const auto cylinder = where.optional_table(group_where_keys.cylinder);
  if (!cylinder) return;
  const Vec3 from = read_vector(*cylinder, cylinder_keys.from, dimension, true);
  const Vec3 along = read_vector(*cylinder, cylinder_keys.to, dimension, true) - from;
  const double radius = read(*cylinder, cylinder_keys.radius), length = norm(along);
  if (!(length > 0))
    throw cylinder->error(cylinder_keys.to, "the axis has no length", "give two different points");
  const Vec3 axis = (1 / length) * along;
  selection.keep_if([&](const Body& body) {
    const Vec3 apart = body.position - from;
    const double height = dot(apart, axis);
    return height >= 0 && height <= length && norm(apart - height * axis) <= radius;
  });
}

// "x from 0 to 1, y from 0 to 2 m": where the centres of all bodies are.
std::string extent_text(const Scene& scene) {
  std::vector<std::string> axes;
  for (int k = 0; k < scene.dimension; ++k) {
    const auto [low, high] =
        std::minmax_element(scene.bodies.begin(), scene.bodies.end(),
                            [k](const Body& a, const Body& b) { return a.position[k] < b.position[k]; });
    axes.push_back(fmt::format("{} from {:g} to {:g}", "xyz"[k], low -> position[k], high -> position[k]));
  }
  return fmt::format("{} m", fmt::join(axes, ", "));
}

std::vector<std::uint32_t> bodies_of_group(const document::Table& group, const std::string& name,
                                           const std::vector<BodySource>& sources, const Scene& scene) {
  const document::Table where = group.table(group_keys.where);
  Selection selection(scene);
  keep_ids(where, scene, selection);
  keep_particles(where, sources, selection);
  keep_material(where, scene, selection);
  keep_ranges(where, scene.dimension, selection);
  keep_sphere(where, scene.dimension, selection);
  keep_cylinder(where, scene.dimension, selection);
  where.refuse_unused();
  if (selection.conditions() == 0)
    throw group.error(group_keys.where, fmt::format("group '{}' has no condition", files::one_line(name)),
                      "give particles, ids, material, x, y or z = [low, high], sphere or cylinder");
  std::vector<std::uint32_t> bodies = selection.bodies();
  if (bodies.empty())
    throw group.error(group_keys.where, fmt::format("group '{}' has no bodies", files::one_line(name)),
                      "correct its conditions: the centres of the " +
                          counted(scene.bodies.size(), "body has ", "bodies have ") + extent_text(scene));
  return bodies;
}

const Key* const probe_selections[] = {&probe_keys.groups, &probe_keys.leave_out};

// The names of groups that a key of a probe gives; `known`: of all groups.
std::vector<std::string> read_group_names(const document::Table& probe, const Key& key,
                                          const std::vector<std::string>& known) {
  const std::vector<std::string> names = probe.strings(key);
  if (names.empty()) throw probe.error(key, "no group is named", "name one, or remove " + key.name);
  for (std::size_t k = 0; k < names.size(); ++k) find_name(probe, key, "group", names[k], known, k);
  return names;
}

std::vector<std::string> group_names(const document::Table& root) {
  std::vector<std::string> names;
  for (const document::Table& group : root.tables("group")) names.push_back(read(group, group_keys.name));
  return names;
}

// Whether bodies in pictures have the colours of their groups.
bool colors_groups(const document::Table& root) {
  const auto snapshot = root.optional_table("snapshot");
  return snapshot && read(*snapshot, snapshot_keys.color_by) == "group";
}

// The names of groups that probes count or leave out, or that pictures show.
std::vector<std::string> observed_groups(const document::Table& root) {
  const std::vector<std::string> known = group_names(root);
  if (colors_groups(root)) return known;
  std::vector<std::string> all;
  for (const document::Table& probe : root.tables("probe"))
    for (const Key* key : probe_selections)
      if (probe.optional(*key))
        for (const std::string& name : read_group_names(probe, *key, known)) all.push_back(name);
  return all;
}

bool are_known(const std::vector<std::string>& names, const Scene& scene) {
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::any_of(scene.selections.begin(), scene.selections.end(),
                       [&](const BodySelection& selection) { return selection.name == name; });
  });
}

// Whether each body is in one of the groups that a key of a probe names.
std::vector<bool> selected_by(const document::Table& probe, const Key& key, const Scene& scene) {
  std::vector<bool> selected(scene.bodies.size(), false);
  for (const std::string& name : probe.strings(key))
    for (const BodySelection& selection : scene.selections)
      if (selection.name == name)
        for (const std::uint32_t i : selection.bodies) selected[i] = true;
  return selected;
}

}  // namespace

void check_colored_groups(const document::Table& root) {
  if (colors_groups(root) && root.tables("group").empty())
    throw root.table("snapshot")
        .error(snapshot_keys.color_by, "the scene has no groups", "add [[group]], or choose another");
}

std::vector<std::uint8_t> read_left_out(const document::Table& probe, const Scene& scene) {
  bool any = false, known = true;
  for (const Key* key : probe_selections)
    if (probe.optional(*key)) any = true, known = known && are_known(probe.strings(*key), scene);
  if (!any || !known) return {};  // unknown: of the bodies of a state that does not exist yet
  std::vector<std::uint8_t> left_out(scene.bodies.size(), 0);
  const auto leave_out = [&](const Key& key, bool which) {
    if (!probe.optional(key)) return;
    const std::vector<bool> selected = selected_by(probe, key, scene);
    for (std::size_t i = 0; i < left_out.size(); ++i) left_out[i] |= selected[i] == which;
  };
  leave_out(probe_keys.groups, false);
  leave_out(probe_keys.leave_out, true);
  if (std::find(left_out.begin(), left_out.end(), 0) == left_out.end())
    throw probe.error(probe.optional(probe_keys.groups) ? probe_keys.groups : probe_keys.leave_out,
                      "no body is left to count", "name fewer groups in leave_out, or more in groups");
  return left_out;
}

void read_groups(const document::Table& root, const std::vector<BodySource>& sources, Scene& scene) {
  UniqueNames names{"group"};
  const std::vector<std::string> observed = observed_groups(root);
  std::vector<freedom::Mask> moved(scene.bodies.size(), 0);
  for (const document::Table& group : root.tables("group")) {
    const std::string name = read(group, group_keys.name);
    names.add(group, name);
    std::vector<std::uint32_t> bodies = bodies_of_group(group, name, sources, scene);
    const bool selected = std::find(observed.begin(), observed.end(), name) != observed.end();
    read_group_motion(group, name, bodies, moved, scene);
    if (selected) scene.selections.push_back({name, std::move(bodies)});
  }
}

}  // namespace scree::scenario
