#pragma once

#include <functional>
#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include <scree/scenario/input_files.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

// Hashes of the contents of the files that a run read (see content_hash.hpp), kept in run.json as "inputs":
// runs with the same text and hashes have the same results. Empty texts for files that cannot be read.
struct InputHashes {
  std::string bodies;  // of several files one hash; empty also without a file of bodies
  std::map<std::string, std::string> plugins;
  friend bool operator==(const InputHashes&, const InputHashes&) = default;
};

InputHashes hashes_of(const scenario::InputFiles& files);
// Saves them; or restores those that a state knows, empty from an earlier version of the program.
InputHashes transfer_inputs(const StateTransfer& state, const InputHashes& now);
// The entry "inputs" of a record.
nlohmann::ordered_json json_of(const InputHashes& hashes);
InputHashes input_hashes_of(const nlohmann::ordered_json& json);
// Of results that began with `before` and go on with `now`. A plug-in that was built again may give other
// results, so that they are those of neither library: its hash becomes "several", with a warning.
InputHashes inputs_after(const InputHashes& before, const InputHashes& now,
                         const std::function<void(const std::string& warning)>& warn);

}  // namespace scree::run
