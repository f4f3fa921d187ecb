#pragma once

#include <string>

#include <scree/document/table.hpp>
#include <scree/parameters.hpp>
#include <scree/plugin_host.hpp>

namespace scree::scenario {

// The plug-in that table's `plugin` key names, its refusal placed at that key.
const scree_plugin& find_plugin(const document::Table& table, scree_kind kind, PluginHost& host);

// Takes the keys of a table that a plug-in declares over into parameters; other keys are left for the caller.
void read_parameters(const document::Table& table, int dimension, Parameters& parameters);

// check_complete with the place of the table.
void check_complete(const document::Table& table, const Parameters& parameters);

// Runs `work`, which knows nothing of the file, and puts the place of the key (or of the table, without such
// a key) before what it throws.
template <class Work>
decltype(auto) placed(const document::Table& table, std::string_view key, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error(table.place(key) + ": " + error.what(), error.status());
  }
}

}  // namespace scree::scenario
