#include "plan_support.hpp"

#include <catch2/catch.hpp>

#include <scree/run/run.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::run;
using namespace scree::test;

namespace {

// Times in the energy series of a run.
std::vector<double> sampled_times(const std::string& text, const std::vector<std::string>& overrides) {
  const TemporaryFolder folder;
  const Plan plan = plan_of(text, overrides);
  RunOptions options;
  options.out = folder / "out";
  run_plan(plan, options);
  std::ifstream file(folder / "out" / "series" / "energy.csv");
  std::string line;
  std::getline(file, line);
  std::vector<double> times;
  while (std::getline(file, line)) times.push_back(std::stod(line));
  return times;
}

}  // namespace

TEST_CASE("samples are taken at the step nearest to each multiple, and at the end", "[run]") {
  // 2.4 steps between samples: at steps 0, 2, 5, 7, 10; a rounded interval of 2 would drift.
  const std::vector<double> times = sampled_times(discs, {"probe.every=2.4e-5"});
  const std::vector<int> steps = {0, 2, 5, 7, 10};
  REQUIRE(times.size() == steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) CHECK(times[k] == Approx(steps[k] * 1e-5).epsilon(1e-12));
}

TEST_CASE("a run ends with a sample even if none is due", "[run]") {
  const std::vector<double> times = sampled_times(discs, {"probe.every=7e-5"});
  REQUIRE(times.size() == 3);
  CHECK(times.back() == Approx(1e-4));
}
