#include "equilibrium/first_event.hpp"

#include "prepared.hpp"

#include <catch2/catch.hpp>

namespace scree::test {

using namespace response;

namespace {

constexpr double cycle_increment = 0.25;  // (s) a 40th of a cycle
const std::function<bool()> proceed = [] { return true; };

// Pairs that begin to slide, touch or part since the beginning of the increment.
std::size_t events_of(const Equilibrium& equilibrium) {
  const std::vector<PairState> before = equilibrium.contacts().states_before(),
                               after = equilibrium.contacts().states_after();
  std::size_t count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const PairStatus from = before[i].status, to = after[i].status;
    count += (from == PairStatus::open) != (to == PairStatus::open) ||
             (from == PairStatus::sticks && to == PairStatus::slides);
  }
  return count;
}

// The fraction of the increment at which the number of events rises above 0, by bisection.
double bisected(Equilibrium& equilibrium, const StaticConfiguration& from, double time,
                const Eigen::VectorXd& motion) {
  double without = 0, with = 1;
  while (with - without > 1e-5) {
    const double share = 0.5 * (without + with);
    REQUIRE(equilibrium.find(from, time + share * cycle_increment, share * motion, proceed).found);
    (events_of(equilibrium) > 0 ? with : without) = share;
  }
  return with;
}

}  // namespace

// Events are located to 1e-4, and approached from before.
TEST_CASE("the first event of an increment is where bisection finds it") {
  const Prepared p(box_of_discs, {"scene.seed=5"});
  Equilibrium equilibrium(*p.simulation, 1e-11);
  StaticConfiguration from(*p.simulation);
  double time = p.simulation->time();
  const Balance start = equilibrium.find(from, time, {}, proceed);
  REQUIRE(start.found);
  equilibrium.accept(start);
  from = start.at;
  int located = 0;
  for (int k = 0; k < 40 && located < 3; ++k) {
    Balance whole = equilibrium.find(from, time + cycle_increment, {}, proceed);
    REQUIRE(whole.found);
    const bool slides = equilibrium.contacts().count(PairStatus::slides) > 0;
    const std::size_t events = events_of(equilibrium);
    const Eigen::VectorXd motion = whole.motion;
    FirstEvent event(equilibrium, from, time, cycle_increment, std::move(whole), proceed);
    double share = event.find();
    if (share == 1) {
      CHECK((events == 0 || events > 8 || !slides ||
             bisected(equilibrium, from, time, motion) < 1e-3 + 1e-4 ||
             bisected(equilibrium, from, time, motion) > 1 - 2e-4));
      // The equilibrium was evaluated elsewhere since.
      equilibrium.find(from, time + cycle_increment, motion, proceed);
    } else {
      ++located;
      CHECK(event.take_balance().found);
      CHECK(share == Approx(bisected(equilibrium, from, time, motion)).margin(2e-4).epsilon(0));
    }
    const Balance next = equilibrium.find(from, time + share * cycle_increment, share * motion, proceed);
    REQUIRE(next.found);
    equilibrium.accept(next);
    from = next.at;
    time += share * cycle_increment;
  }
  CHECK(located == 3);
}

}  // namespace scree::test
