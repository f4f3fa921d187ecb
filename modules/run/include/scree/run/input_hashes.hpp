#pragma once

#include <map>
#include <string>

#include <scree/scenario/input_files.hpp>

namespace scree::run {

// Hashes of the contents of the files that a run read (see content_hash.hpp), kept in run.json as "inputs": runs with
// the same text and hashes have the same results. Empty texts for files that cannot be read.
struct InputHashes {
  std::string bodies;  // empty also without a file of bodies
  std::map<std::string, std::string> plugins;
  friend bool operator==(const InputHashes&, const InputHashes&) = default;
};

InputHashes hashes_of(const scenario::InputFiles& files);

}  // namespace scree::run
