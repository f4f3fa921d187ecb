#pragma once

#include <cstdint>
#include <string>

#include <scree/stage.hpp>

namespace scree::run {

// Takes a simulation through its stages until they are over or proceed(runner) says no. begin(stage name) is
// called before the first step of each stage; observe(stage name, steps since its beginning) at its start, at
// its end, and at the step that it returned last time as the next one to look at. Returns the name of the
// last stage.
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
