#pragma once

#include <filesystem>
#include <string>

#include <scree/report/record.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::run {

// Results in a directory with a record, and the state from which they go on.
struct ResultKind {
  RunDirectory::Kind directory;
  const char* noun;          // for messages, such as "spectrum"
  const char* record;        // file, with "status" and "scenario"
  const char* state;         // file; null: none, or several
  const char* group;         // of the state, with the scenario as resolved
  bool keeps_state = false;  // when finished too
};

inline constexpr ResultKind run_results{RunDirectory::Kind::run, "run", "run.json", nullptr, "run"};
inline constexpr ResultKind spectrum_results{
    RunDirectory::Kind::spectrum, "spectrum", "spectrum.json", "state.h5", "spectrum", true};
inline constexpr ResultKind modes_results{RunDirectory::Kind::modes, "table of modes", "modes.json", nullptr,
                                          ""};
inline constexpr ResultKind quasi_static_results{RunDirectory::Kind::quasi_static, "quasi-static load",
                                                 "quasi_static.json", "state.h5", "quasi_static"};
inline constexpr ResultKind accuracy_results{RunDirectory::Kind::accuracy, "accuracy study", "accuracy.json",
                                             nullptr, ""};

// The scenario as resolved, in any of these directories.
inline constexpr const char* scenario_file = "scenario.toml";

// Whether a directory has results of a kind.
bool has_results(const std::filesystem::path& directory, const ResultKind& kind);

using report::parse_record;

}  // namespace scree::run
