#include <tuple>

#include <catch2/catch.hpp>

#include <scree/accuracy/study.hpp>

using namespace scree;
using namespace scree::accuracy;

namespace {

// Outcomes with a wall time (s) and the errors of two quantities.
Convergence outcomes(const std::vector<std::tuple<double, double, double>>& all) {
  Convergence study;
  study.tolerance = 0.01;
  for (const auto& [wall, first, second] : all) {
    SettingResult result;
    result.wall_time = wall;
    result.errors = {first, second};
    study.outcomes.push_back(result);
  }
  return study;
}

}  // namespace

TEST_CASE("the cheapest setting is the fastest of those whose worst error is within the tolerance",
          "[accuracy]") {
  Convergence study = outcomes({{1, 0.5, 0.001}, {4, 0.001, 0.002}, {3, 0.01, 0.01}, {2, 0.001, 0.02}});
  CHECK(cheapest(study) == &study.outcomes[2]);
  CHECK(study.outcomes[0].worst() == 0.5);
  CHECK(study.outcomes[3].worst_quantity() == 1);
  study.outcomes[2].problem = "the time step is too long";
  CHECK(cheapest(study) == &study.outcomes[1]);
  study.tolerance = 1e-4;
  CHECK(cheapest(study) == nullptr);
}

TEST_CASE("the Pareto front has the settings that none is faster and more exact than", "[accuracy]") {
  const Convergence study = outcomes({{3, 0.1, 0.3}, {1, 0.5, 0.2}, {2, 0.49, 0.6}, {4, 0.2, 0.1}});
  using Front = std::vector<const SettingResult*>;
  // 0.49 is less than 5 % below 0.5.
  CHECK(pareto_front(study, 0) == Front{&study.outcomes[1], &study.outcomes[0]});
  CHECK(pareto_front(study, 1) == Front{&study.outcomes[1], &study.outcomes[3]});
  CHECK(pareto_front(study) == Front{&study.outcomes[1], &study.outcomes[0], &study.outcomes[3]});
}
