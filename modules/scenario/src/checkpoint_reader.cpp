#include "output_keys.hpp"
#include "readers.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace scree::scenario {

namespace {

constexpr const char* wall_time_cure =
    "give a number above 0 with s, min, h or d, such as \"30 s\", \"10 min\", \"2 h\" or \"never\"";

}  // namespace

std::optional<double> parse_wall_time(const std::string& text) {
  if (text == "never") return std::nullopt;
  constexpr std::pair<std::string_view, double> units[] = {{"s", 1}, {"min", 60}, {"h", 3600}, {"d", 86400}};
  double number = 0;
  const auto [rest, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::size_t unit_at = text.find_first_not_of(' ', std::size_t(rest - text.data()));
  const std::string_view unit = unit_at == std::string::npos ? "" : std::string_view(text).substr(unit_at);
  for (const auto& [name, seconds] : units)
    if (failed == std::errc() && unit == name && number > 0 && std::isfinite(number * seconds))
      return number * seconds;
  throw Error("", fmt::format("'{}' is not a wall time", text), wall_time_cure);
}

CheckpointPlan read_checkpoint(const document::Table& root, double step) {
  const document::Table t = root.table_or_empty("checkpoint");
  CheckpointPlan plan;
  if (t.has("every") && !t.is_string("every"))
    throw t.error("every", "checkpoint.every is not a text with a unit",
                  fmt::format("{}, or every_time in s of simulated time", wall_time_cure));
  const std::string every = read(t, checkpoint_keys.every);
  plan.every = placed(t, "every", [&] { return parse_wall_time(every); });
  if (t.optional(checkpoint_keys.every_time))
    plan.every_time = read_steps(t, checkpoint_keys.every_time, step);
  plan.final_state = read(t, checkpoint_keys.final_state);
  plan.stage_states = read(t, checkpoint_keys.stage_states);
  return plan;
}

}  // namespace scree::scenario
