#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <scree/nearest.hpp>
#include <scree/scenario/document.hpp>
#include <scree/scenario/plan.hpp>

#include "output_reader.hpp"
#include "particles_reader.hpp"
#include "plugin_parameters.hpp"
#include "stage_reader.hpp"

namespace scree::scenario {

namespace {

std::vector<Material> read_materials(const Table& root) {
  std::vector<Material> materials;
  std::set<std::string> names;
  for (const Table& t : root.tables("material")) {
    materials.push_back({t.string("name"), t.number("density", Range::positive("kg/m^3"))});
    if (!names.insert(materials.back().name).second)
      throw t.error("name", fmt::format("material '{}' is defined twice", materials.back().name), "use another name");
  }
  if (materials.empty())
    throw root.error("material", "the scene has no [[material]]", "add [[material]] with name and density (kg/m^3)");
  return materials;
}

// Names of plug-in instances are unique across kinds, because stages refer to them.
std::string instance_name(const Table& t, const std::string& plugin, std::set<std::string>& taken) {
  const std::string name = t.string("name", plugin);
  if (!taken.insert(name).second)
    throw t.error("name", fmt::format("the name '{}' is taken", name), "give this entry a name of its own");
  return name;
}

class Reader {
 public:
  Reader(const Table& root, PluginHost& host) : root_(root), host_(host) {}

  Plan read(const std::filesystem::path& source) {
    read_scene_header();
    plan_.source = source;
    materials_ = read_materials(root_);
    for (const Material& material : materials_) scene().materials.push_back(material.name);
    scene().bodies = read_bodies(root_, scene().dimension, materials_, plan_.seed, source.parent_path());
    read_contacts();
    read_boundaries();
    read_body_terms();
    plan_.stages = read_stages(root_, scene(), instances_);
    for (const Stage& stage : plan_.stages)
      for (const Stage::Change& change : stage.changes)
        if (change.kind == SCREE_CONTACT_LAW && turns_bodies(change.parameters, scene().dimension)) scene().spin = true;
    read_time();
    plan_.probes = read_probes(root_, scene(), plan_.stages, host_);
    plan_.snapshot = read_snapshot(root_);
    plan_.charts = read_charts(root_, plan_.probes, scene().dimension);
    plan_.expectations = read_expectations(root_, plan_.probes, scene().dimension);
    return std::move(plan_);
  }

 private:
  Scene& scene() { return plan_.scene; }

  void read_scene_header() {
    const Table t = root_.table_or_empty("scene");
    plan_.title = t.string("title", "");
    scene().dimension = int(t.integer("dimension", 3, Range::between(2, 3)));
    plan_.seed = std::uint64_t(t.integer("seed", 1, Range::non_negative()));
    const Table limits = root_.table_or_empty("limits");
    scene().limits.overlap_ratio = limits.number("overlap_ratio", scene().limits.overlap_ratio, Range::positive());
    scene().limits.speed = limits.number("speed", 0.0, Range::positive("m/s"));
    scene().skin = root_.table_or_empty("neighbours").number("skin", 0.0, Range::positive("m"));
  }

  void read_contacts() {
    const std::size_t n = materials_.size();
    constexpr std::uint32_t none = ~0u;
    scene().law_of.assign(n * n, none);
    for (const Table& t : root_.tables("contact")) {
      Parameters parameters(find_plugin(t, SCREE_CONTACT_LAW, host_));
      read_parameters(t, scene().dimension, parameters);
      check_complete(t, parameters);
      const std::string name = instance_name(t, parameters.plugin().name, taken_);
      placed(t, "plugin", [&] { turns_bodies(parameters, scene().dimension); });
      instances_.push_back({SCREE_CONTACT_LAW, name, parameters});
      const auto law = std::uint32_t(scene().laws.size());
      scene().laws.push_back({name, parameters});
      if (t.has("between"))
        assign_pair(t, law);
      else if (!fallback_)
        fallback_ = law;
      else
        throw t.error("a second [[contact]] says nothing of the materials that it is for", "add between = [\"a\", \"b\"]");
    }
    if (fallback_) std::replace(scene().law_of.begin(), scene().law_of.end(), none, *fallback_);
    const auto open = std::find(scene().law_of.begin(), scene().law_of.end(), none);
    if (open != scene().law_of.end()) {
      const std::size_t pair = std::size_t(open - scene().law_of.begin());
      throw root_.error("contact", fmt::format("no [[contact]] says how '{}' and '{}' touch", materials_[pair / n].name, materials_[pair % n].name),
                        fmt::format("add a [[contact]] with plugin = {}", fmt::join(host_.names(SCREE_CONTACT_LAW), " or ")));
    }
  }

  void assign_pair(const Table& t, std::uint32_t law) {
    const std::vector<std::string> names = t.strings("between");
    if (names.size() != 2) throw t.error("between", fmt::format("names {} materials", names.size()), "name two, such as [\"bead\", \"wall\"]");
    std::size_t index[2];
    for (int k = 0; k < 2; ++k) {
      const auto& all = scene().materials;
      const auto found = std::find(all.begin(), all.end(), names[k]);
      if (found == all.end()) {
        const auto near = nearest_word(names[k], all);
        throw t.error("between", std::size_t(k), fmt::format("no material '{}'", names[k]),
                      near ? fmt::format("did you mean '{}'?", *near) : fmt::format("there are: {}", fmt::join(all, ", ")));
      }
      index[k] = std::size_t(found - all.begin());
    }
    const std::size_t n = materials_.size();
    scene().law_of[index[0] * n + index[1]] = scene().law_of[index[1] * n + index[0]] = law;
  }

  void read_boundaries() {
    for (const Table& t : root_.tables("boundary")) {
      Parameters parameters(find_plugin(t, SCREE_BOUNDARY, host_));
      read_parameters(t, scene().dimension, parameters);
      check_complete(t, parameters);
      const std::string name = instance_name(t, parameters.plugin().name, taken_);
      std::uint32_t material = 0;
      if (t.has("material") || materials_.size() > 1) {
        const std::string wanted = t.string("material", materials_[0].name);
        const auto& all = scene().materials;
        material = std::uint32_t(std::find(all.begin(), all.end(), wanted) - all.begin());
        if (material == all.size()) throw t.error("material", fmt::format("no material '{}'", wanted), fmt::format("there are: {}", fmt::join(all, ", ")));
      }
      scene().boundaries.push_back({name, material, parameters});
      instances_.push_back({SCREE_BOUNDARY, name, parameters});
      placed(t, "plugin", [&] { check_boundaries(); });
    }
  }

  // Configures the boundaries read so far, so that a refusal gets the place of the last of them.
  void check_boundaries() {
    Vec3 lower = {}, upper = {};
    for (int k = 0; k < scene().dimension && !scene().bodies.empty(); ++k) {
      lower[k] = infinity_, upper[k] = -infinity_;
      for (const Body& body : scene().bodies) {
        lower[k] = std::min(lower[k], body.position[k] - body.radius);
        upper[k] = std::max(upper[k], body.position[k] + body.radius);
      }
    }
    Boundaries(scene().boundaries, scene().dimension, lower, upper);
  }

  void read_body_terms() {
    for (const Table& t : root_.tables("body_force")) {
      Parameters parameters(find_plugin(t, SCREE_BODY_TERM, host_));
      read_parameters(t, scene().dimension, parameters);
      check_complete(t, parameters);
      const std::string name = instance_name(t, parameters.plugin().name, taken_);
      scene().body_terms.push_back({name, parameters});
      instances_.push_back({SCREE_BODY_TERM, name, parameters});
      placed(t, "plugin", [&] { BodyTerms({{name, parameters}}, scene().dimension); });
    }
  }

  void read_time() {
    const Table t = root_.table("time");
    scene().audit = t.boolean("energy_audit", true);
    if (!t.is_table("step")) {
      scene().step = t.number("step", Range::positive("s"));
      return;
    }
    const Table step = t.table("step");
    const double fraction = step.number("fraction", Range::positive());
    const double speed = step.number("speed", 1.0, Range::positive("m/s"));
    const double contact = shortest_contact_time(scene(), speed);
    if (!std::isfinite(contact))
      throw step.error("fraction", "the scene has no pair of bodies whose contact time could be taken", "give time.step in s");
    scene().step = fraction * contact;
  }

  static constexpr double infinity_ = std::numeric_limits<double>::infinity();
  const Table root_;
  PluginHost& host_;
  Plan plan_;
  std::vector<Material> materials_;
  std::vector<Stage::Change> instances_;
  std::set<std::string> taken_;
  std::optional<std::uint32_t> fallback_;
};

}  // namespace

Plan read_plan(const std::filesystem::path& path, const std::vector<std::string>& overrides, PluginHost& host) {
  const Document document = Document::load(path, overrides);
  Plan plan = Reader(document.root(), host).read(path);
  document.refuse_unused();
  plan.resolved_text = document.resolved_text();
  return plan;
}

}  // namespace scree::scenario
