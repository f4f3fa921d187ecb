#include "plan_support.hpp"

#include <atomic>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/accuracy/report.hpp>
#include <scree/accuracy/study.hpp>

using namespace scree;
using namespace scree::accuracy;
using test::plan_of;
using test::TemporaryFolder;

namespace {

// A sphere on a plane under its weight, displaced by 2 mm from rest at 0.99 m: z = 0.99 + 0.002 cos(ωt), ω² =
// 1000, after 0.128 s.
const std::string oscillator =
    "[time]\nstep = 1e-3\nduration = 0.128\n"
    "[[material]]\nname = 'ball'\ndensity = 1\n"
    "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1000\nnormal_damping = 0\n"
    "[[boundary]]\nplugin = 'plane'\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
    "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, 0, -10]\n"
    "[[particle]]\nradius = 1\nmass = 1\nposition = [0, 0, 0.992]\n"
    "[[probe]]\nplugin = 'particles'\nids = [1]\nevery = 0.128\n"
    "[[expect]]\nrequirement = 'where it is'\nquantity = 'particles.z_1.last'\n"
    "tolerance = 1e-4\nscale = 0.002\nreference = ";

const double exact = 0.99 + 0.002 * std::cos(std::sqrt(1000.0) * 0.128);

scenario::Plan closed_form_plan() { return plan_of(oscillator + fmt::format("{:.17g}\n", exact)); }

StudyOptions quick() {
  StudyOptions options;
  options.coarsest = 2;
  options.count = 4;
  return options;
}

const Order& order_of(const Convergence& study, Integration integration) {
  for (const Order& order : study.orders)
    if (order.integration == integration) return order;
  throw std::runtime_error("no such method");
}

}  // namespace

TEST_CASE("a study finds the orders of the integrators from the closed form, and from extrapolation",
          "[accuracy]") {
  const Convergence by_form = study(closed_form_plan(), quick());
  REQUIRE(by_form.quantities.size() == 2);
  CHECK(by_form.quantities[0].closed_form);
  CHECK(*order_of(by_form, Integration::velocity_verlet).of_worst == Approx(2).margin(0.1));

  const Convergence by_limit = study(plan_of(oscillator + "0\nof_step = true\n"), quick());
  CHECK_FALSE(by_limit.quantities[0].closed_form);
  // Extrapolation leaves an error of the fourth order in steps of at most ω h/2 = 0.004.
  CHECK(by_limit.quantities[0].reference == Approx(exact).margin(0.002 * std::pow(0.004, 4) + 1e-13));
  CHECK(*order_of(by_limit, Integration::velocity_verlet).of_worst == Approx(2).margin(0.1));
  CHECK(*order_of(by_limit, Integration::fourth_order).of_worst == Approx(4).margin(0.2));
  CHECK_FALSE(by_limit.horizon.has_value());
  CHECK(by_limit.duration == Approx(0.128));
}

TEST_CASE("a study compares the amplitude that a lock-in measures", "[accuracy]") {
  const std::string measured =
      oscillator + fmt::format("{:.17g}\n", exact) +
      fmt::format(
          "[[probe]]\nplugin = 'lock_in'\nof = 'particles.z_1'\nfrequency_hz = {:.17g}\nperiods = 0.6\n"
          "harmonics = 1\ndrift_degree = 0\nevery = 0.128\n"
          "[[expect]]\nrequirement = 'amplitude'\nquantity = 'lock_in.amplitude.last'\n"
          "reference = 0.002\ntolerance = 1e-4\n",
          std::sqrt(1000.0) / (2 * std::numbers::pi));
  StudyOptions options = quick();
  options.integrations = {Integration::velocity_verlet};
  const Convergence result = study(plan_of(measured), options);
  REQUIRE(result.quantities.size() == 3);
  CHECK(result.quantities[1].name == "lock_in.amplitude.last");
  CHECK(result.quantities[1].closed_form);
  std::vector<double> errors;
  for (const SettingResult& o : result.outcomes) errors.push_back(o.errors.at(1));
  REQUIRE(errors.size() == 4);
  // Of second order: eight times smaller steps, 64 times smaller errors, but for where samples lie in a
  // period.
  CHECK(errors[0] > 30 * errors[3]);
  CHECK(errors[3] < 1e-4);
}

TEST_CASE("the cheapest setting meets the tolerance and no cheaper one does", "[accuracy]") {
  const Convergence result = study(closed_form_plan(), quick());
  const SettingResult* best = cheapest(result);
  REQUIRE(best);
  CHECK(best->worst() <= result.tolerance);
  for (const SettingResult& o : result.outcomes)
    if (o.problem.empty() && o.wall_time < best->wall_time) CHECK(o.worst() > result.tolerance);
  const auto front = pareto_front(result);
  for (std::size_t k = 1; k < front.size(); ++k) {
    CHECK(front[k]->wall_time >= front[k - 1]->wall_time);
    CHECK(front[k]->worst() < front[k - 1]->worst());
  }
  CHECK(verdict(result).starts_with("The cheapest setting within 0.001 is "));
  StudyOptions strict = quick();
  strict.tolerance = 1e-16;
  strict.integrations = {Integration::velocity_verlet};
  CHECK(verdict(study(closed_form_plan(), strict))
            .starts_with("No setting is within 1e-16; the most accurate is "));
}

TEST_CASE("a step refused by the step guard is a row with the reason, and the study continues",
          "[accuracy]") {
  StudyOptions options = quick();
  options.coarsest = 64;  // ω h = 2.02
  options.count = 3;
  options.integrations = {Integration::velocity_verlet};
  const Convergence result = study(closed_form_plan(), options);
  REQUIRE(result.outcomes.size() == 3);
  CHECK(result.outcomes[0].problem.find("is too long: the contacts of law") != std::string::npos);
  CHECK(result.outcomes[0].problem.find(';') == std::string::npos);
  CHECK(result.outcomes[2].problem.empty());
}

TEST_CASE("a study is written as CSV with a column per quantity, as JSON and as charts", "[accuracy]") {
  const TemporaryFolder folder;
  RecordedStudyOptions options;
  static_cast<StudyOptions&>(options) = quick();
  options.integrations = {Integration::velocity_verlet};
  options.out = folder / "out";
  CHECK(recorded_study(closed_form_plan(), options).second == options.out);
  std::ifstream csv(folder.path() / "out/accuracy.csv");
  std::string header, row;
  std::getline(csv, header);
  CHECK(header ==
        "integrator,step_s,steps,wall_s,worst_error,particles.z_1.last,particles.z_1.last_error,"
        "positions,positions_error,problem");
  int rows = 0;
  while (std::getline(csv, row)) ++rows;
  CHECK(rows == 4);
  const auto record = nlohmann::json::parse(test::text_of(folder / "out/accuracy.json"));
  CHECK(record["status"] == "finished");
  CHECK(record["orders"].size() == 1);
  CHECK(std::filesystem::file_size(folder.path() / "out/charts/worst_error.png") > 10000);
  CHECK(std::filesystem::exists(folder.path() / "out/charts/positions.png"));
}

TEST_CASE("a study that is stopped before its reference is complete is an error", "[accuracy]") {
  const std::atomic<bool> stop = true;
  StudyOptions options = quick();
  options.stop = &stop;
  CHECK_THROWS_WITH(study(closed_form_plan(), options), Catch::Contains("before the reference was complete"));
}

TEST_CASE("a study with a directory writes nothing before its reference is complete, and then what it has",
          "[accuracy]") {
  const TemporaryFolder folder;
  std::atomic<bool> stop = true;
  RecordedStudyOptions options;
  static_cast<StudyOptions&>(options) = quick();
  options.out = folder / "out";
  options.stop = &stop;
  CHECK_THROWS_WITH(recorded_study(closed_form_plan(), options),
                    Catch::Contains("before the reference was complete"));
  CHECK_FALSE(std::filesystem::exists(folder / "out"));
  stop = false;
  options.on_progress = [&](double, const std::string& what) { stop = what.starts_with("position_verlet"); };
  CHECK(recorded_study(closed_form_plan(), options).first.interrupted);
  CHECK(nlohmann::json::parse(test::text_of(folder / "out/accuracy.json"))["status"] == "interrupted");
}
