#pragma once

#include <string>

#include <scree/plugin_host.hpp>

namespace scree::tool {

// What holds when a parameter is not given: "required", "default 0.5", "this or restitution".
std::string when_absent(const scree_parameter& parameter);

// Prints all tables of a scenario and all plug-ins with their keys, as scenarios/KEYS.md has them.
void print_markdown(PluginHost& host);

}  // namespace scree::tool
