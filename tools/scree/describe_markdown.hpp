#pragma once

#include <string>
#include <vector>

#include <scree/plugin_host.hpp>

namespace scree::tool {

// Parameters of a plug-in that differ in their keys only.
struct ParameterLine {
  std::string keys;     // see folded()
  std::string range;    // see describe_range()
  std::string without;  // what holds when none is given: "required", "default 0.5", "this or restitution"
  std::string doc;
};
std::vector<ParameterLine> parameter_lines_of(const scree_plugin& plugin);

// Prints all tables of a scenario and all plug-ins with their keys, as scenarios/KEYS.md has them.
void print_markdown(PluginHost& host);

}  // namespace scree::tool
