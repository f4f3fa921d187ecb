#include "state/group_record.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/scene_record.hpp>

namespace scree {

namespace {

constexpr const char *group_names = "group_names", *group_prefix = "group_", *selections_path = "selections";

// A function of time is stored where it is given.
template <class Group, class Visit>
void each_program(Group& group, std::size_t number, const Visit& visit) {
  const auto all = [&](const char* name, auto& programs) {
    for (std::size_t k = 0; k < programs.size(); ++k)
      visit(fmt::format("{}{}_{}_{}", group_prefix, number, name, k), programs[k]);
  };
  all("velocity", group.velocity);
  all("displacement", group.displacement);
  all("load", group.load);
}

StoredRange index_below(std::size_t bodies) { return stored::at_most(std::max<std::size_t>(bodies, 1) - 1); }

}  // namespace

void save_groups(const StateTransfer& state, const std::vector<BodyGroup>& groups) {
  if (groups.empty()) return;
  std::vector<std::string> names;
  for (const BodyGroup& group : groups) names.push_back(group.name);
  state.rows(group_names, "", names);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::vector<std::uint32_t> bodies = groups[g].bodies;
    state.rows(fmt::format("{}{}_bodies", group_prefix, g), "", bodies);
    each_program(groups[g], g, [&](const std::string& name, const std::vector<double>& program) {
      std::vector<double> numbers = program;
      if (!program.empty()) state.rows(name, "", numbers);
    });
  }
}

std::vector<BodyGroup> groups_of(const State& state) { return groups_of(state, recorded_ids(state).size()); }

std::vector<BodyGroup> groups_of(const State& state, std::size_t bodies) {
  const StateTransfer scene = StateTransfer::restoring_from(state).below("scene");
  if (!scene.has(group_names)) return {};
  std::vector<std::string> names;
  scene.rows(group_names, "", names);
  std::vector<BodyGroup> groups(names.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g].name = names[g];
    scene.rows(fmt::format("{}{}_bodies", group_prefix, g), "", groups[g].bodies, 1, index_below(bodies));
    each_program(groups[g], g, [&](const std::string& name, std::vector<double>& program) {
      if (scene.has(name)) scene.rows(name, "", program);
    });
  }
  return groups;
}

void save_selections(const StateTransfer& state, const std::vector<BodySelection>& selections) {
  if (selections.empty()) return;
  std::vector<std::string> names;
  for (const BodySelection& selection : selections) names.push_back(selection.name);
  const StateTransfer below = state.below(selections_path);
  below.rows("names", "", names);
  for (std::size_t g = 0; g < selections.size(); ++g) {
    std::vector<std::uint32_t> bodies = selections[g].bodies;
    below.rows(fmt::format("{}_bodies", g), "", bodies);
  }
}

std::vector<BodySelection> selections_of(const State& state) {
  const StateTransfer below = StateTransfer::restoring_from(state).below(selections_path);
  if (!below.has("names")) return {};
  std::vector<std::string> names;
  below.rows("names", "", names);
  const std::size_t bodies = recorded_ids(state).size();
  std::vector<BodySelection> selections;
  for (std::size_t g = 0; g < names.size(); ++g) {
    selections.push_back({names[g], {}});
    below.rows(fmt::format("{}_bodies", g), "", selections[g].bodies, 1, index_below(bodies));
  }
  return selections;
}

}  // namespace scree
