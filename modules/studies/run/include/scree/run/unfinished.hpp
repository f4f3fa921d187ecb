#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <scree/plugin_host.hpp>
#include <scree/run/result_kind.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/state.hpp>

namespace scree::run {

// Results that were interrupted, and with what they go on.
struct Unfinished {
  RunDirectory directory;  // taken
  State state;
  std::filesystem::path file;  // of the state
  scenario::Plan plan;         // text_for_any_folder: set if scenario.toml is to be restored
};

// What is in a directory with one state. on_warning: one line "<what>; <cure>"; may be empty. Throws Error
// (bad_input) if it has no such results, if these are finished, or if their state is missing or is that of
// others. The host must outlive it.
Unfinished unfinished_in(const std::filesystem::path& path, const ResultKind& kind, PluginHost& host,
                         const std::function<void(const std::string&)>& on_warning);

// The text of scenario.toml as results that go on began with it, if it was edited or removed since, which is
// reported; empty if it is still so. began: the scenario in their state. The path of a file of bodies, which
// is absolute in scenario.toml only, is taken from there.
std::string restored_scenario(const std::filesystem::path& directory, const std::string& began,
                              const std::function<void(const std::string&)>& on_warning);

}  // namespace scree::run
