#include "readers.hpp"
#include "scene_keys.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::scenario {

namespace {

std::vector<double> read_value(const document::Table& table, const scree_parameter& p, int dimension,
                               const ListReader& read_list) {
  switch (scree_type(p.type)) {
    case SCREE_INTEGER:
      return {double(table.integer(p.key))};
    case SCREE_BOOLEAN:
      return {table.boolean(p.key) ? 1.0 : 0.0};
    case SCREE_CHOICE: {
      const std::vector<std::string> words = choices_of(p);
      const std::string word = table.choice(p.key, words);
      return {double(std::find(words.begin(), words.end(), word) - words.begin())};
    }
    case SCREE_VECTOR: {
      std::vector<double> v = table.numbers(p.key, std::size_t(dimension));
      v.resize(3, 0.0);
      return v;
    }
    case SCREE_LIST:
      return read_list ? read_list(table, p.key) : table.numbers(p.key);
    case SCREE_PROGRAM:
      return read_program(table, p.key);
    case SCREE_MESH_FILE:
    case SCREE_INPUT:
    case SCREE_NUMBER:
      break;
  }
  return {table.number(p.key)};
}

// End of the cure if a parameter is missing: the key that may be meant for it.
std::string misspelt(const document::Table& table, const Parameters& parameters) {
  const scree_plugin& plugin = parameters.plugin();
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const scree_parameter& p = plugin.parameters[k];
    if (parameters.given(p.key) || !(p.excludes || (p.flags & SCREE_REQUIRED))) continue;
    if (const std::string cure = table.misspelt(p.key); !cure.empty()) return cure;
  }
  return "";
}

// Whether a law or a body force is there. Boundaries leave out single walls by keys of their own.
void read_absence(const document::Table& table, Parameters& parameters) {
  const std::uint32_t kind = parameters.plugin().kind;
  if (kind != SCREE_CONTACT_LAW && kind != SCREE_BODY_FORCE) return;
  const ChoiceKey& control = kind == SCREE_CONTACT_LAW ? contact_keys.control : body_force_keys.control;
  if (table.optional(control)) parameters.set_absent(read(table, control) == "absent");
}

}  // namespace

const scree_plugin& find_plugin(const document::Table& table, scree_kind kind, PluginHost& host) {
  const std::string name = table.string("plugin");
  if (name.size() >= SCREE_MAX_NAME)
    throw table.error("plugin", fmt::format("the name of the plug-in has {} or more letters", SCREE_MAX_NAME),
                      "see scree describe for the names");
  if (const std::string shown = files::escaped(name); shown != name)
    throw table.error("plugin", fmt::format("the name '{}' has control characters", shown),
                      "see scree describe for the names");
  return placed(table, "plugin", [&]() -> const scree_plugin& { return host.find(name, kind); });
}

void read_parameters(const document::Table& table, int dimension, const MeshReader& read_mesh,
                     Parameters& parameters, const ListReader& read_list) {
  const scree_plugin& plugin = parameters.plugin();
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const scree_parameter& p = plugin.parameters[k];
    if (p.type == SCREE_INPUT || !table.optional(p.key)) continue;
    std::vector<double> data =
        p.type == SCREE_MESH_FILE ? read_mesh(table, p.key) : read_value(table, p, dimension, read_list);
    if (const auto wrong = Parameters::problem(p, data))
      throw table.error(p.key, fmt::format("{} {}", p.key, wrong->problem()), wrong->cure());
    parameters.set(p.key, std::move(data));
  }
  read_absence(table, parameters);
}

void check_complete(const document::Table& table, const Parameters& parameters) {
  try {
    parameters.check_complete();
  } catch (const Error& error) {
    throw Error(error.place(), error.problem(), error.cure() + misspelt(table, parameters))
        .at(table.place("plugin"));
  }
}

}  // namespace scree::scenario
