#include "scene_keys.hpp"

#include "group_keys.hpp"
#include "output_keys.hpp"
#include "particles_keys.hpp"

#include <scree/integration.hpp>
#include <scree/scenario/study_table.hpp>

namespace scree::scenario {

std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for (const IntegrationTraits& traits : integrations()) names.emplace_back(traits.name);
  return names;
}

std::vector<TableDescription> describe_tables(const StudyTables& studies) {
  const TableKeys* const all[] = {
      &scene_keys,    &time_keys,        &step_keys,     &limits_keys,   &neighbours_keys,   &particles_keys,
      &lattice_keys,  &random_keys,      &region_keys,   &springs_keys,  &radius_keys,       &particle_keys,
      &group_keys,    &group_where_keys, &sphere_keys,   &cylinder_keys, &material_keys,     &contact_keys,
      &boundary_keys, &body_force_keys,  &stage_keys,    &until_keys,    &until_column_keys, &probe_keys,
      &derived_keys,  &chart_keys,       &snapshot_keys, &cut_keys,      &fields_keys,       &checkpoint_keys,
      &expect_keys};
  std::vector<TableDescription> tables;
  for (const TableKeys* keys : all) tables.push_back(keys->description());
  for (const StudyTable& study : studies)
    for (TableDescription& table : study.describe()) tables.push_back(std::move(table));
  return tables;
}

}  // namespace scree::scenario
