#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <scree/plugin_host.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/state.hpp>

namespace scree::run {

// Results with a record and one state from which they go on: spectra, responses.
struct ResultKind {
  RunDirectory::Kind directory;
  const char* noun;    // for messages, such as "spectrum"
  const char* record;  // file, with "status" and "scenario"
  const char* state;   // file
  const char* group;   // of the state, with the scenario as resolved
};

inline constexpr ResultKind spectrum_results{RunDirectory::Kind::spectrum, "spectrum", "spectrum.json",
                                             "state.h5", "spectrum"};
inline constexpr ResultKind response_results{RunDirectory::Kind::response, "response", "response.json",
                                             "state.h5", "quasi_static"};

// Whether a directory has results of a kind.
bool has_results(const std::filesystem::path& directory, const ResultKind& kind);

// With what results go on.
struct Unfinished {
  State state;
  scenario::Plan plan;
};

// on_warning: one line "<what>; <cure>"; may be empty.
using OnWarning = std::function<void(const std::string&)>;

// The directory of such results, taken. Throws Error (bad_input) if it has none.
RunDirectory directory_of(const std::filesystem::path& path, const ResultKind& kind,
                          const OnWarning& on_warning);

// What is in it; Plan::text_for_any_folder is set if scenario.toml is to be restored. Throws Error (bad_input) if the results are finished,
// or if their state is missing or is that of others. The host must outlive it.
Unfinished unfinished_in(const RunDirectory& directory, const ResultKind& kind, PluginHost& host,
                         const OnWarning& on_warning);

}  // namespace scree::run
