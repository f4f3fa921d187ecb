#include "plan_support.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include <scree/parameters.hpp>
#include <scree/scenario/study_table.hpp>

using namespace scree;
using namespace scree::test;

namespace {

const scenario::TableDescription& table_named(const std::vector<scenario::TableDescription>& tables,
                                              const std::string& name) {
  return *std::find_if(tables.begin(), tables.end(), [&](const auto& table) { return table.name == name; });
}

// The keys that the readers of a table have read, as the refusal of an unknown key lists them.
std::set<std::string> keys_read(const std::string& refused) {
  const std::string opening = "known keys: ";
  const auto at = refused.find(opening);
  INFO(refused);
  REQUIRE(at != std::string::npos);
  std::set<std::string> keys;
  std::istringstream list(refused.substr(at + opening.size()));
  for (std::string key; std::getline(list >> std::ws, key, ',');) keys.insert(key);
  return keys;
}

// A scene that has every table once; `zzz` is the unknown key.
const std::string every_table =
    with(with(std::string(discs), "duration = 1e-4\n", "energy_audit = true\n"), "[scene]\n", "[scene]\n") +
    "[limits]\noverlap_ratio = 0.4\n[neighbours]\nskin = 1e-3\n[[body_force]]\nplugin = 'gravity'\nacceleration = [0, -9]\n"
    "[[stage]]\nduration = 1e-4\n[[particle]]\nposition = [1, 1]\nradius = 0.01\n[snapshot]\ncolor_by = 'radius'\n"
    "[[expect]]\nrequirement = 'r'\nquantity = 'steps'\nat_least = 1\n"
    "[[chart]]\nname = 'c'\nprobe = 'energy'\ny = 'residual'\n"
    "[[group]]\nname = 'g'\nfixed = true\n[group.where]\nids = [1]\n[group.where.sphere]\ncentre = [0, 0]\nradius = 1\n"
    "[group.where.cylinder]\nfrom = [0, 0]\nto = [1, 1]\nradius = 1\n";

}  // namespace

TEST_CASE("every key that a reader reads is declared in its table", "[scenario]") {
  REQUIRE(refusal(every_table) == "no error");
  const auto tables = scenario::describe_tables();
  const std::pair<const char*, const char*> places[] = {{"scene", "scene"},
                                                        {"time", "time"},
                                                        {"limits", "limits"},
                                                        {"neighbours", "neighbours"},
                                                        {"particles", "particles"},
                                                        {"particle", "particle"},
                                                        {"material", "material"},
                                                        {"stage", "stage"},
                                                        {"snapshot", "snapshot"},
                                                        {"expect", "expect"},
                                                        {"chart", "chart"},
                                                        {"group", "group"},
                                                        {"group.where", "group.where"},
                                                        {"group.where.sphere", "group.where.sphere"},
                                                        {"group.where.cylinder", "group.where.cylinder"},
                                                        {"particles.lattice", "particles.lattice"}};
  for (const auto& [name, path] : places) {
    CAPTURE(name);
    std::set<std::string> declared;
    for (const auto& key : table_named(tables, name).keys) declared.insert(key.name);
    for (const std::string& key : keys_read(refusal(every_table, {std::string(path) + ".zzz=1"}))) {
      CAPTURE(key);
      CHECK(declared.contains(key));
    }
  }
}

TEST_CASE("tables of plug-ins declare the keys that no plug-in has", "[scenario]") {
  const auto tables = scenario::describe_tables();
  const std::pair<const char*, scree_kind> places[] = {{"contact", SCREE_CONTACT_LAW},
                                                       {"boundary", SCREE_BOUNDARY},
                                                       {"body_force", SCREE_BODY_FORCE},
                                                       {"probe", SCREE_PROBE}};
  const std::string plugins[] = {"linear_spring_dashpot", "box", "gravity", "energy"};
  for (std::size_t k = 0; k < std::size(places); ++k) {
    const auto& [name, kind] = places[k];
    CAPTURE(name);
    std::set<std::string> declared;
    for (const auto& key : table_named(tables, name).keys) declared.insert(key.name);
    const scree_plugin& plugin = host().find(plugins[k], kind);
    for (std::uint32_t p = 0; p < plugin.parameter_count; ++p) declared.insert(plugin.parameters[p].key);
    for (const std::string& key : keys_read(refusal(every_table, {std::string(name) + ".zzz=1"})))
      CHECK(declared.contains(key));
  }
}

TEST_CASE("descriptions of keys have a value, a default and a meaning", "[scenario]") {
  for (const auto& table : scenario::describe_tables()) {
    std::set<std::string> names;
    for (const auto& key : table.keys) {
      CAPTURE(table.name, key.name);
      CHECK_FALSE(key.value.empty());
      CHECK_FALSE(key.absent.empty());
      CHECK_FALSE(key.doc.empty());
      CHECK(names.insert(key.name).second);
    }
  }
}
