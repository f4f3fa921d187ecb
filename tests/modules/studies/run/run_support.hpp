#pragma once

#include "plan_support.hpp"

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

}  // namespace scree::test
