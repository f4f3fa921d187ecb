#pragma once

#include "plan_support.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <scree/run/set_up.hpp>
#include <scree/simulation.hpp>
#include <scree/stage.hpp>

namespace scree::test {

inline constexpr const char* box_of_discs = SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml";
inline constexpr const char* box_of_spheres = SCREE_TEST_SOURCE "/scenarios/david2005/cycles.toml";

// A scenario at the beginning of its last stage.
struct Prepared {
  scenario::Plan plan;
  std::unique_ptr<Simulation> simulation;

  Prepared(const char* file, const std::vector<std::string>& overrides)
      : Prepared(scenario::read_plan(file, overrides, host())) {}
  explicit Prepared(scenario::Plan given) : plan(std::move(given)), simulation(run::set_up(plan)) {
    StageRunner stages(*simulation, plan.stages);
    while (stages.current() + 1 < plan.stages.size()) stages.run(1000, [] { return true; });
  }
  std::unique_ptr<Simulation> from(const State& state) const {
    return std::make_unique<Simulation>(scene_in_stage(plan.scene, plan.stages, plan.stages.size() - 1),
                                        state);
  }
};

}  // namespace scree::test
