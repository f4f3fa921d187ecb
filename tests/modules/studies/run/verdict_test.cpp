#include "run_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/run/verdict.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;

namespace {

scenario::Expectation expectation_of(const std::string& quantity) {
  scenario::Expectation e;
  e.requirement = "r", e.quantity = quantity;
  return e;
}

}  // namespace

TEST_CASE("expectations are judged by their bounds", "[run]") {
  const Bench bench(
      std::string(discs) +
      "[[expect]]\nrequirement = 'a'\nquantity = 'steps'\nreference = 10\ntolerance = 0\n"
      "[[expect]]\nrequirement = 'b'\nquantity = 'steps'\nreference = 11\ntolerance = 0.5\n"
      "[[expect]]\nrequirement = 'c'\nquantity = 'energy.time.max'\nat_most = 1.1e-4\nat_least = 1e-5\n"
      "[[expect]]\nrequirement = 'd'\nquantity = 'energy.time.mean'\nat_least = 1\n"
      "[[expect]]\nrequirement = 'e'\nquantity = 'energy.time.first'\nreference = 0\ntolerance = 0\n");
  const std::vector<Verdict> verdicts = bench.run().verdicts;
  REQUIRE(verdicts.size() == 5);
  const bool met[] = {true, false, true, false, true};
  for (std::size_t k = 0; k < 5; ++k) CHECK(verdicts[k].met == met[k]);
  CHECK(verdicts[3].value == Approx(5e-5));
}

TEST_CASE("a bound is met by the value on it, and by no value that is not a number", "[run]") {
  scenario::Expectation near = expectation_of("q"), between = near;
  near.reference = 2, near.tolerance = 0.5;
  between.at_least = 1, between.at_most = 3;
  for (const auto& [value, met] :
       {std::pair(1.5, true), {2.5, true}, {std::nextafter(1.5, 0), false}, {NAN, false}})
    CHECK(judged(near, value).met == met);
  for (const auto& [value, met] :
       {std::pair(1.0, true), {3.0, true}, {0.99, false}, {3.01, false}, {NAN, false}})
    CHECK(judged(between, value).met == met);
}

TEST_CASE("an expectation is judged by a number of the run, or by a statistic of a series", "[run]") {
  const auto column = [](const std::string& probe, const std::string& name) {
    CHECK(probe == "wall");
    CHECK(name == "force");
    return std::vector<double>{3, 1, 5};
  };
  const auto value = [&](const char* quantity) {
    scenario::Expectation e = expectation_of(quantity);
    e.at_least = 0;
    return judge_expectation(e, {{"steps", 7}}, column).value;
  };
  CHECK(value("steps") == 7);
  CHECK(value("wall.force.max") == 5);
  CHECK(value("wall.force.mean") == 3);
  CHECK(value("wall.force.first") == 3);
}

TEST_CASE("a record has the bounds that an expectation gives, and no others", "[run]") {
  scenario::Expectation e = expectation_of("q");
  e.at_most = 3;
  CHECK(json_of(std::vector{judged(e, 4)}).dump() ==
        R"([{"requirement":"r","quantity":"q","value":4.0,"met":false,"at_most":3.0}])");
}
