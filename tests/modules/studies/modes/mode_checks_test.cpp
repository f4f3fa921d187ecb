#include "mode_checks.hpp"

#include "bead_row.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/error.hpp>

using namespace scree;
using namespace scree::modes;
using namespace scree::test;

namespace {

// The problem of the Error that the action throws; empty if there is none.
template <class Action>
std::string problem_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("modes are not looked for where there are none", "[vibration]") {
  const response::LinearSystem system = chain();
  const response::UndampedSystem undamped(system);
  const auto refused = [&](const VibrationOptions& options) {
    return problem_of([&] { check_search(undamped, options); });
  };
  VibrationOptions options;
  CHECK(refused(options).empty());
  // A row of beads has modes up to 2 sqrt(k/m)/2π.
  const double highest = 2 * std::sqrt(stiffness / mass) / (2 * std::numbers::pi);
  options.near_hz = 0.9 * highest;
  CHECK(refused(options).empty());
  options.near_hz = 10 * highest;
  CHECK_THAT(refused(options), Catch::Contains("give a lower --near"));
  options = {};
  options.density = 10, options.density_to_hz = 1e-12;
  CHECK_THAT(refused(options), Catch::Contains("can be told from a floppy one; give a higher --density-to"));
  options.density_to_hz = 1e101;
  CHECK_THAT(problem_of([&] { check_density(options); }), Catch::Contains("give a lower --density-to"));
  options.density_to_hz = 1e99;
  CHECK(problem_of([&] { check_density(options); }).empty());
}

TEST_CASE("what is doubtful about modes is warned of, and nothing of those that are sound", "[vibration]") {
  Vibration vibration;
  vibration.complete = true;
  for (int k = 1; k <= 3; ++k) {
    Mode mode{};
    mode.kind = ModeKind::vibrating;
    mode.number = k;
    mode.residual = k == 2 ? 0.01 : 0.1;
    vibration.modes.push_back(mode);
  }
  CHECK(mode_warnings(vibration, true, 1).empty());
  const std::vector<std::string> residuals = mode_warnings(vibration, true, 0.01);
  REQUIRE(residuals.size() == 1);
  CHECK_THAT(residuals[0], Catch::Contains("residuals are above 0.01, those of: 1, 3;"));
  vibration.unstable = 1, vibration.floppy = 2, vibration.complete = false;
  const std::vector<std::string> all = mode_warnings(vibration, false, 1);
  REQUIRE(all.size() == 4);
  CHECK_THAT(all[1], Catch::Contains("the packing is unstable: 1 mode grows"));
  CHECK_THAT(all[2], Catch::Contains("2 modes are floppy; see floppy.csv"));
  CHECK_THAT(all[3], Catch::Contains("ask for more with --modes"));
}
