#pragma once

#include <string>

#include <scree/document/table.hpp>
#include <scree/parameters.hpp>
#include <scree/plugin_host.hpp>

namespace scree::scenario {

// Finds the plug-in named by the `plugin` key of the table. Throws Error at that key.
const scree_plugin& find_plugin(const document::Table& table, scree_kind kind, PluginHost& host);

// Copies the keys of a table that the plug-in declares to `parameters`; other keys, and columns of other probes, are left for
// the caller.
void read_parameters(const document::Table& table, int dimension, Parameters& parameters);

// Throws Error at the table unless all required parameters are given.
void check_complete(const document::Table& table, const Parameters& parameters);

// Runs `work` and prefixes its Error with the position of the key in the file (of the table if it has no such
// key).
template <class Work>
decltype(auto) placed(const document::Table& table, std::string_view key, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error(table.place(key) + ": " + error.what(), error.status());
  }
}

}  // namespace scree::scenario
