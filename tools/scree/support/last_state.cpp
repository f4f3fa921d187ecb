#include "support/last_state.hpp"

#include <algorithm>
#include <vector>

#include <scree/error.hpp>

namespace scree::tool {

namespace fs = std::filesystem;

std::optional<fs::path> last_state(const fs::path& run) {
  std::error_code failed;
  std::vector<fs::path> states;
  const fs::path at_end = run / "final_state.h5";
  for (const auto& entry : fs::directory_iterator(run / "checkpoint", failed))
    if (entry.path().extension() == ".h5") states.push_back(entry.path());
  std::optional<fs::path> latest;
  if (!states.empty()) latest = *std::max_element(states.begin(), states.end());
  // A run that was prolonged and interrupted has checkpoints after its last end.
  if (fs::exists(at_end, failed) &&
      (!latest || fs::last_write_time(at_end, failed) >= fs::last_write_time(*latest, failed)))
    return at_end;
  return latest;
}

fs::path state_of(const fs::path& source) {
  if (source.extension() == ".h5") return source;
  if (const auto state = last_state(source)) return *state;
  throw Error(source.string(), "has no state", "give the directory of a run that has one, or a state (.h5)");
}

}  // namespace scree::tool
