#pragma once

#include "plan_support.hpp"

#include <optional>
#include <string>
#include <vector>

#include <scree/run/run.hpp>

namespace scree::test {

// A plan and a folder for its run.
struct Bench {
  TemporaryFolder folder;
  scenario::Plan plan;
  run::RunOptions options;

  explicit Bench(const std::string& text = discs, const std::vector<std::string>& overrides = {})
      : plan(plan_of(text, overrides)) {
    options.out = folder / "out";
  }
  run::RunResult run() const { return run::run_plan(plan, options); }
};

// `discs` in two stages of five steps each.
inline const std::string two_stages = with(discs, "duration = 1e-4\n", "") +
                                      "[[stage]]\nname = 'first'\nduration = 5e-5\n"
                                      "[[stage]]\nname = 'second'\nduration = 5e-5\n";

// Goes on with the run of a bench. until: (s)
inline run::RunResult resume(const Bench& bench, const std::vector<std::string>& overrides = {},
                             std::optional<double> until = {}) {
  return run::resume_run(bench.options, {overrides, until, {}}, host());
}

// The line with which that is refused.
inline std::string resume_refusal(const Bench& bench, const std::vector<std::string>& overrides = {},
                                  std::optional<double> until = {}) {
  return message([&] { resume(bench, overrides, until); });
}

inline std::string series_of(const Bench& bench, const std::string& probe) {
  return text_of(bench.options.out / "series" / (probe + ".csv"));
}

}  // namespace scree::test
