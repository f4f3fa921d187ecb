#include "state/scene_message.hpp"

#include <string>
#include <vector>

#include <scree/scene_record.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

namespace {

// What the record of a scene leaves out.
void transfer_rest(const StateTransfer& state, Scene& scene) {
  state.value("integration", "", scene.integration, stored::any);
  state.value("expected_speed", "", scene.expected_speed, stored::any);
  state.value("skin", "", scene.skin, stored::any);
  state.value("min_bodies_per_thread", "", scene.min_bodies_per_thread, stored::any);
  state.value("pair_forces", "", scene.pair_forces);
  state.value("sliding_work", "", scene.sliding_work);
  state.value("spin", "", scene.spin);
  state.value("orientations", "", scene.orientations);
  state.value("largest_overlap_ratio", "", scene.limits.overlap_ratio, stored::any);
  state.value("largest_speed", "", scene.limits.speed, stored::any);
}

Parameters parameters_in(const RecordedPlugin& recorded, scree_kind kind, PluginHost& host) {
  return parameters_of(host.find(recorded.plugin, kind), recorded.parameters);
}

}  // namespace

State message_of(const Scene& scene, const BodyFacts& bodies) {
  State message;
  const StateTransfer to = StateTransfer::saving_to(message);
  save_scene(to.below("scene"), scene);
  BodyFacts facts = bodies;
  facts.transfer(to.below("facts"));
  std::vector<std::uint32_t> materials;
  for (const Scene::Boundary& boundary : scene.boundaries) materials.push_back(boundary.material);
  to.rows("boundary_materials", "", materials);
  Scene rest = scene;  // is const otherwise
  transfer_rest(to.below("rest"), rest);
  return message;
}

Scene scene_of(const State& message, PluginHost& host) {
  const StateTransfer from = StateTransfer::restoring_from(message), recorded = from.below("scene");
  Scene scene;
  scene.dimension = dimension_of(message);
  recorded.value("step", "s", scene.step);
  recorded.value("energy_audit", "", scene.audit);
  recorded.rows("materials", "", scene.materials);
  recorded.rows("law_of", "", scene.law_of, std::max<std::size_t>(1, scene.materials.size()));
  transfer_rest(from.below("rest"), scene);
  scene.groups = groups_of(message, facts_in(message).count);
  for (const RecordedPlugin& law : recorded_laws(message))
    scene.laws.push_back({law.name, parameters_in(law, SCREE_CONTACT_LAW, host)});
  std::vector<std::uint32_t> materials;
  from.rows("boundary_materials", "", materials);
  for (const RecordedPlugin& boundary : recorded_boundaries(message))
    scene.boundaries.push_back({boundary.name, materials.at(scene.boundaries.size()),
                                parameters_in(boundary, SCREE_BOUNDARY, host)});
  for (const RecordedPlugin& force : recorded_body_forces(message))
    scene.body_forces.push_back({force.name, parameters_in(force, SCREE_BODY_FORCE, host)});
  return scene;
}

BodyFacts facts_in(const State& message) {
  BodyFacts facts;
  facts.transfer(StateTransfer::restoring_from(message).below("facts"));
  return facts;
}

}  // namespace scree
