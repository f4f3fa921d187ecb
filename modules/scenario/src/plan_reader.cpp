#include "readers.hpp"
#include "scene_keys.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/probes.hpp>
#include <scree/scenario/drive_sampling.hpp>
#include <scree/scenario/quantities.hpp>
#include <scree/scene_checks.hpp>
#include <scree/step_guard.hpp>

namespace scree::scenario {

namespace {

void read_header(const document::Table& root, Plan& plan) {
  const document::Table t = root.table_or_empty("scene");
  Scene& scene = plan.scene;
  plan.title = read(t, scene_keys.title);
  scene.dimension = int(read(t, scene_keys.dimension));
  plan.seed = std::uint64_t(read(t, scene_keys.seed));
  const document::Table limits = root.table_or_empty("limits");
  scene.limits.overlap_ratio = read(limits, limits_keys.overlap_ratio);
  scene.limits.speed = read_optional(limits, limits_keys.speed).value_or(0);
  scene.skin = read_optional(root.table_or_empty("neighbours"), neighbours_keys.skin).value_or(0);
}

// Reads the materials and bodies. Returns the periodic boxes of packings.
std::vector<PackingBox> read_materials_and_bodies(const document::Table& root, RecordedBodies recorded,
                                                  Plan& plan) {
  const std::vector<Material> materials = read_materials(root);
  plan.scene.materials = names_of(materials);
  plan.bodies_place = root.place(root.has("particles") ? "particles" : "particle");
  if (!recorded.bodies.empty()) {
    check_ids(recorded.bodies);
    plan.scene.bodies = std::move(recorded.bodies);
    plan.scene.groups = std::move(recorded.groups);
    plan.scene.selections = std::move(recorded.selections);
    return {};
  }
  ReadBodies read = read_bodies(root, plan.scene.dimension, materials, plan.seed, plan.source.parent_path());
  plan.scene.bodies = std::move(read.bodies);
  plan.scene.springs = std::move(read.springs);
  read_groups(root, read.sources, plan.scene);
  plan.from_state = std::move(read.state);
  plan.branching = read.branching;
  plan.body_sources = std::move(read.sources);
  return read.boxes;
}

void read_boundaries(const document::Table& root, PluginHost& host, Instances& instances, Plan& plan) {
  Scene& scene = plan.scene;
  std::size_t walls = 0;
  for (const document::Table& t : root.tables("boundary")) {
    const Stage::Change& read = read_instance(t, SCREE_BOUNDARY, host, scene, instances);
    const std::size_t walls_before = walls;
    scene.boundaries.push_back({read.name, 0, read.parameters});
    // Checks all boundaries so far together: each can be valid alone but not in combination.
    placed(t, "plugin", [&] { walls = wall_count(scene); });
    const bool has_walls = walls > walls_before;
    const std::string material = scene.materials.size() > 1 && has_walls
                                     ? t.string(boundary_keys.material)
                                     : t.string(boundary_keys.material, scene.materials[0]);
    scene.boundaries.back().material =
        std::uint32_t(find_name(t, "material", "material", material, scene.materials));
    const bool periodic = periodic_domain(scene).any_periodic();
    if (periodic && plan.periodic_place.empty()) plan.periodic_place = t.place("plugin");
  }
}

// A periodic packing does not make the scene periodic, and its bodies may touch through its faces.
void warn_of_box(const PackingBox& box, Plan& plan) {
  const Domain& file = box.domain;
  const Domain scene = periodic_domain(plan.scene);
  std::vector<std::string> in_file, in_scene;
  bool any_own = false;
  for (int k = 0; k < plan.scene.dimension; ++k) {
    const double own = scene.periodic[std::size_t(k)] ? scene.length(k) : 0, length = file.length(k);
    if (!file.periodic[std::size_t(k)] || std::abs(own - length) <= 1e-9 * length) continue;
    const char axis = "xyz"[k];
    in_file.push_back(fmt::format("{} from {:g} to {:g} m", axis, file.lower[k], file.upper[k]));
    in_scene.push_back(own > 0 ? fmt::format("along {} over {:g} m", axis, own)
                               : fmt::format("not along {}", axis));
    any_own |= own > 0;
  }
  if (in_file.empty()) return;
  plan.warnings.push_back(
      fmt::format("{} is periodic along {}, and the scene is {}; give [[boundary]] "
                  "with plugin = \"periodic\", axes, lower and upper if it is to be the same",
                  box.name.empty() ? "the file of bodies" : fmt::format("the packing of '{}'", box.name),
                  fmt::join(in_file, ", "), any_own ? fmt::format("{}", fmt::join(in_scene, ", ")) : "not"));
}

void read_body_forces(const document::Table& root, PluginHost& host, Scene& scene, Instances& instances) {
  for (const document::Table& t : root.tables("body_force")) {
    const Stage::Change& read = read_instance(t, SCREE_BODY_FORCE, host, scene, instances);
    scene.body_forces.push_back({read.name, read.parameters});
  }
}

Integration read_integration(const document::Table& time) {
  const std::string name = read(time, time_keys.integrator);
  return std::find_if(integrations().begin(), integrations().end(),
                      [&](const IntegrationTraits& traits) { return name == traits.name; })
      ->integration;
}

// A key of earlier versions, which their scenarios and states have.
void check_precision(const document::Table& time) {
  if (!time.has("precision") || time.string("precision") == "double") return;
  throw time.error("precision", "all numbers are double; mixed precision has been removed",
                   "remove it; a run that began with it goes on as a new one from its state "
                   "(particles.state)");
}

void read_time(const document::Table& root, Plan& plan) {
  const document::Table t = root.table("time");
  Scene& scene = plan.scene;
  std::optional<document::Table> step;
  if (t.is_table(time_keys.step))
    step = t.table(time_keys.step);
  else
    scene.step = read(t, time_keys.step);
  plan.step_guard = read(t, time_keys.step_guard);
  plan.step_place = t.place("step");
  scene.expected_speed = read_optional(t, time_keys.expected_speed).value_or(0);
  scene.audit = read(t, time_keys.energy_audit);
  scene.integration = read_integration(t);
  check_precision(t);
  if (!step) return;
  const double fraction = read(*step, step_keys.fraction);
  const double contact = shortest_contact_time(scene, expected_speed(scene));
  if (!std::isfinite(contact))
    throw step->error("fraction", "the scene has no pair of bodies to compute a contact time from",
                      "give time.step in seconds");
  scene.step = fraction * contact;
}

// TOML that runs from any folder: with the paths of packings, meshes and of a state made absolute.
std::string text_for_any_folder(const document::Document& document, const std::filesystem::path& path,
                                std::vector<std::string> overrides) {
  const std::vector<BodyFile> files = body_files(document, path);
  if (files.empty()) return document.resolved_text();
  for (const BodyFile& file : files)
    overrides.push_back(
        fmt::format("{}=\"{}\"", file.key, files::escaped(file.path.string(), files::Escapes::toml)));
  try {
    return document::Document::load(path, overrides).resolved_text();
  } catch (const Error&) {
    return document.resolved_text();  // a folder whose name is not UTF-8 cannot be written in TOML
  }
}

// Notes which tables of studies there are, and has them checked.
void read_studies(const document::Table& root, const StudyTables& studies, Plan& plan) {
  for (const StudyTable& study : studies)
    if (root.has(study.name)) plan.studies.push_back(study.name);
  for (const StudyTable& study : studies) study.check(plan);
}

// Reads everything except the texts. recorded: of a run that goes on; without bodies, they are read too.
// studies: null if the scenario has been checked before.
Plan read(const document::Document& document, const std::filesystem::path& path, RecordedBodies recorded,
          PluginHost& host, const StudyTables* studies) {
  const document::Table root = document.root();
  if (root.has("campaign"))
    throw root.error("campaign", "the file is a campaign, not a scenario",
                     fmt::format("run it with scree campaign {}", path.string()));
  Plan plan;
  plan.source = path;
  plan.document = document;
  read_header(root, plan);
  Instances instances;
  instances.read_mesh = recorded.boundaries.empty() ? read_meshes_from(path.parent_path())
                                                    : recorded_meshes(recorded.boundaries);
  const std::vector<PackingBox> boxes = read_materials_and_bodies(root, std::move(recorded), plan);
  read_contacts(root, host, plan.scene, instances);
  read_boundaries(root, host, instances, plan);
  for (const PackingBox& box : boxes) warn_of_box(box, plan);
  read_body_forces(root, host, plan.scene, instances);
  read_time(root, plan);
  plan.stages = read_stages(root, plan.scene, instances, studies, plan.warnings);
  for (const std::string& line : undersampled_drives(plan.scene, plan.stages))
    plan.warnings.push_back(fmt::format("{}: {}", plan.source.string(), line));
  plan.scene.spin = needs_spin(plan);
  plan.probes = read_probes(root, plan.scene, plan.stages, host);
  find_conditions(root, plan.probes, plan.scene.dimension, plan.stages);
  check_colored_groups(root);
  plan.snapshot = read_snapshot(root, plan.scene.dimension, plan.scene.step);
  plan.fields = read_fields(root, plan.scene, plan.stages);
  plan.checkpoint = read_checkpoint(root, plan.scene.step);
  std::vector<ProbeColumns> columns;
  for (const ProbePlan& probe : plan.probes) columns.push_back(columns_of(probe, plan.scene.dimension));
  plan.charts = read_charts(root, columns);
  read_expectations(root, studies, plan);
  note_needs(plan);
  check_audit(root, plan);
  check_pictures(root, plan);
  if (studies) read_studies(root, *studies, plan);
  return plan;
}

}  // namespace

Plan read_plan(const std::filesystem::path& path, const std::vector<std::string>& overrides, PluginHost& host,
               const StudyTables& studies) {
  const document::Document document = document::Document::load(path, overrides);
  Plan plan = read(document, path, {}, host, &studies);
  document.refuse_unused();
  plan.resolved_text = document.resolved_text();
  plan.text_for_any_folder = text_for_any_folder(document, path, overrides);
  plan.files = input_files(document, path, host);
  plan.inputs = {path};
  plan.inputs.insert(plan.inputs.end(), plan.files.bodies.begin(), plan.files.bodies.end());
  for (const std::string& line : host.slow_laws()) plan.warnings.push_back(line);
  return plan;
}

Plan read_plan_again(const std::string& text, const std::string& name,
                     const std::vector<std::string>& overrides, RecordedBodies recorded, PluginHost& host) {
  const document::Document document = document::Document::parse(text, name, overrides);
  Plan plan = read(document, name, std::move(recorded), host, nullptr);
  // Only here, since overrides change lengths only, and keys of bodies stay unread.
  document.root().table("time").refuse_unused();
  for (const document::Table& stage : document.root().tables("stage")) stage.refuse_unused();
  plan.files.plugins = plugin_files(document, host);
  plan.resolved_text = document.resolved_text();
  return plan;
}

void check_keys(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                std::vector<Body> bodies, PluginHost& host, const StudyTables& studies) {
  const document::Document document = document::Document::load(path, overrides);
  for (Body& body : bodies) body.material = 0;
  try {
    read(document, path, {std::move(bodies), {}, {}, {}}, host, &studies);
  } catch (const Error&) {
    return;  // it may fit the bodies of the state
  }
  for (const char* table : {"particles", "particle", "group"}) document.root().accept(table);
  document.refuse_unused();
}

std::string length_override(const std::string& resolved_text, double seconds) {
  const document::Document document = document::Document::parse(resolved_text, "the scenario");
  const std::vector<document::Table> stages = document.root().tables("stage");
  if (stages.empty()) return fmt::format("time.duration={}", document::number_text(seconds));
  const document::Table& last = stages.back();
  const std::string entry = stages.size() > 1 ? fmt::format("stage[{}]", stages.size() - 1) : "stage";
  if (!last.has(stage_keys.cycles))
    return fmt::format("{}.duration={}", entry, document::number_text(seconds));
  return fmt::format("{}.cycles={}", entry,
                     document::number_text(seconds / last.number(stage_keys.period.name)));
}

}  // namespace scree::scenario
