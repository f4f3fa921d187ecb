#pragma once

#include <filesystem>
#include <optional>

#include <scree/cycles/cycle_series.hpp>

namespace scree::tool {

// The cycles of a run.
struct RunCycles {
  cycles::CycleTimes times;
  double end = 0;  // (s) of their stage; that of the series if the stage has not ended
  // "running", "interrupted" or "failed" where they ended before their stage; empty if they did not.
  std::string status = {};
};

// Those of the last stage with a `period` in the directory of a run; none if no stage has one. Those of a quasi-static load, with a period of 0 if it has none.
// Throws Error for a directory without scenario.toml or run.json, and if this stage has not run.
std::optional<RunCycles> cycles_of_run(const std::filesystem::path& directory);

// "running", "interrupted" or "failed" where the record in a directory says so; else empty.
std::string unfinished_status(const std::filesystem::path& directory);

}  // namespace scree::tool
