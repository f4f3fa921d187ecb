#pragma once

#include "plan_support.hpp"

#include <string>

namespace scree::test {

// Two cycles of the stress on a box of discs, with this seed.
inline scenario::Plan cycled_discs(const std::string& seed) {
  return scenario::read_plan(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml",
                             {"scene.seed=" + seed, "stage.cycles.cycles=2", "time.step=1e-3"}, host());
}

}  // namespace scree::test
