#include "plugins/clock.hpp"

#include <cstdint>

#include <scree/plugin/program.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

void Clock::restart(double time, const std::vector<std::string>& going_on) {
  std::map<std::string, double> ahead;
  for (const std::string& key : going_on) {
    const auto before = ahead_.find(key);
    ahead[key] = at(time) + (before == ahead_.end() ? 0 : before->second);
  }
  ahead_ = std::move(ahead);
  start_ = time;
}

Parameters Clock::shown(Parameters parameters) const {
  const std::vector<scree_value> values = parameters.values();
  std::map<std::string, std::vector<double>> changed;
  for (std::uint32_t k = 0; k < parameters.plugin().parameter_count; ++k) {
    const scree_parameter& p = parameters.plugin().parameters[k];
    const auto ahead = ahead_.find(p.key);
    if (p.type != SCREE_PROGRAM || ahead == ahead_.end() || values[k].count == 0) continue;
    std::vector<double>& data = changed[p.key] = {Program::ahead, ahead->second};
    data.insert(data.end(), values[k].data, values[k].data + values[k].count);
  }
  for (auto& [key, data] : changed) parameters.set(key, std::move(data));
  return parameters;
}

void Clock::transfer(const StateTransfer& state) {
  state.value("clock_start", "s", start_);
  // Only of plug-ins of which a stage has set a part.
  if (state.restoring() ? !state.has("going_on") : ahead_.empty()) return ahead_.clear();
  std::vector<std::string> keys;
  std::vector<double> ahead;
  for (const auto& [key, by] : ahead_) keys.push_back(key), ahead.push_back(by);
  state.rows("going_on", "", keys);
  state.rows("ahead", "s", ahead);
  if (keys.size() != ahead.size()) state.refuse("ahead", "does not have a time for each key in 'going_on'");
  ahead_.clear();
  for (std::size_t k = 0; k < keys.size(); ++k) ahead_[keys[k]] = ahead[k];
}

}  // namespace scree
