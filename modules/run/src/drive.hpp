#pragma once

#include <cstdint>
#include <string>

#include <scree/stage.hpp>

namespace scree::run {

// Runs a simulation through its stages until they end or proceed(runner) returns false. Calls begin(stage
// name) before the first step of each stage, and observe(stage name, steps since the start of the stage) at
// the start and end of each stage and at the step that its last call returned. Returns the last stage name.
template <class Begin, class Observe, class Proceed>
std::string drive(StageRunner& runner, const Begin& begin, const Observe& observe, const Proceed& proceed) {
  std::size_t stage = 0;
  std::uint64_t steps = 0, next = 0;
  const auto name = [&] { return runner.stages()[stage].name; };
  const auto start = [&] {
    begin(name());
    next = observe(name(), steps = 0);
  };
  start();
  while (!runner.finished() && proceed(runner)) {
    steps += runner.run(next - steps, [&] { return proceed(runner); });
    next = observe(name(), steps);
    if (runner.current() == stage || runner.finished()) continue;
    stage = runner.current();
    start();
  }
  return name();
}

}  // namespace scree::run
