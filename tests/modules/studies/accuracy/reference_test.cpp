#include "reference.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::accuracy;

TEST_CASE("extrapolation is exact for pure first and second order, and estimates its uncertainty",
          "[accuracy]") {
  for (const double order : {1.0, 2.0}) {
    const auto at = [&](double h) { return 3 + 0.7 * std::pow(h, order); };
    const Limit limit = extrapolate(at(0.4), at(0.2), at(0.1));
    CHECK(limit.value == Approx(3).epsilon(1e-14));
    CHECK(limit.uncertainty < 1e-14);
  }
  // Second order plus a fourth-order term: the remaining error is that of the fourth order, between h/2 and
  // h/4.
  const auto at = [](double h) { return 3 + 0.7 * h * h + 5 * std::pow(h, 4); };
  const Limit limit = extrapolate(at(0.4), at(0.2), at(0.1));
  CHECK(std::abs(limit.value - 3) <= limit.uncertainty);
  CHECK(limit.uncertainty < 20 * std::abs(limit.value - 3));
}

namespace {

// Runs with the steps h, h/2, h/4 of a quantity with an error of second order, and of one that is unknown.
std::vector<run::InMemoryRun> runs_of(double limit, double error) {
  std::vector<run::InMemoryRun> runs(3);
  for (int k = 0; k < 3; ++k) {
    runs[std::size_t(k)].quantities = {limit + error * std::pow(0.25, k), NAN};
    runs[std::size_t(k)].positions = {Vec3{{1 + error * std::pow(0.25, k), 0, 0}}, Vec3{{0, 2, 0}}};
  }
  return runs;
}

scenario::Expectation expectation_of(const std::string& quantity) {
  scenario::Expectation e;
  e.requirement = "r", e.quantity = quantity;
  return e;
}

scenario::Plan plan_with(const std::vector<scenario::Expectation>& expectations) {
  scenario::Plan plan;
  plan.expectations = expectations;
  return plan;
}

}  // namespace

TEST_CASE("a reference is the closed form, 0 of a residual, or the limit of vanishing steps", "[accuracy]") {
  const auto reference = [](scenario::Expectation e, bool cut = false) {
    return reference_quantities(plan_with({e}), runs_of(3, 0.16), {0}, cut)[0];
  };
  scenario::Expectation e = expectation_of("wall.force.last");
  e.reference = 3.5, e.tolerance = 1;
  CHECK(reference(e).reference == 3.5);
  CHECK(reference(e).closed_form);
  // Cut short, or with a closed form for the step of the file alone, the limit: an error of second order
  // leaves none.
  CHECK(reference(e, true).reference == Approx(3).epsilon(1e-14));
  e.of_step = true;
  CHECK(reference(e).reference == Approx(3).epsilon(1e-14));
  CHECK(reference(e).uncertainty < 1e-14);
  CHECK_FALSE(reference(e).closed_form);
  CHECK(reference(expectation_of("energy_residual")).reference == 0);
}

TEST_CASE("quantities of the run itself and those without a value are not compared", "[accuracy]") {
  const scenario::Plan plan =
      plan_with({expectation_of("wall.force.last"), expectation_of("wall.force.max")});
  std::vector<std::string> without;
  CHECK(compared_expectations(plan, runs_of(3, 0.16), without) == std::vector<std::size_t>{0});
  CHECK(without == std::vector<std::string>{"wall.force.max"});
  without.clear();
  CHECK(compared_expectations(plan_with({expectation_of("steps")}), runs_of(3, 0.16), without).empty());
  CHECK(without.empty());
}

TEST_CASE("positions of the reference are the limit of each coordinate", "[accuracy]") {
  const ReferencePositions found = reference_positions(runs_of(3, 0.16));
  REQUIRE(found.positions.size() == 2);
  CHECK(found.positions[0][0] == Approx(1).epsilon(1e-14));
  CHECK(found.positions[1][1] == 2);
  CHECK(found.uncertainty < 1e-13);
}
