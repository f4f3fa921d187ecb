#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace scree::run {

// When the load of a run was cycled, as its record says.
struct RecordedLoad {
  double period = 0;  // (s) 0: the load has none
  double start = 0;   // (s) of its stage
  double end = 0;     // (s) of its stage; the largest double while the stage is not finished
  // "running", "interrupted" or "failed" if the run stopped before the end of the stage; else empty.
  std::string status = {};
};

// Reads the record in a directory of results: of the last stage that has a `period`, nullopt without one; of
// a quasi-static load, whose record names its times. Throws Error for a directory without scenario.toml or
// run.json, and if the stage has not begun.
std::optional<RecordedLoad> recorded_load(const std::filesystem::path& directory);

// "running", "interrupted" or "failed" if the record in a directory says so; else empty.
std::string unfinished_status(const std::filesystem::path& directory);

}  // namespace scree::run
