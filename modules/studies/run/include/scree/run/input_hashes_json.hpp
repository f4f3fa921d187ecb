#pragma once

#include <nlohmann/json_fwd.hpp>

#include <scree/run/input_hashes.hpp>

namespace scree::run {

// The entry "inputs" of run.json and spectrum.json.
nlohmann::ordered_json json_of(const InputHashes& hashes);
InputHashes input_hashes_of(const nlohmann::ordered_json& json);

}  // namespace scree::run
