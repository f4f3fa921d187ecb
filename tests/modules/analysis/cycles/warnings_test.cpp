#include <catch2/catch.hpp>

#include <scree/cycles/warnings.hpp>

using namespace scree::cycles;

namespace {

// A strain that follows a load, whose minima are these, with a stiffness of 100.
CyclesSource elastic(std::vector<double> minima) {
  CyclesSource source;
  source.period = 10;
  for (const double load : minima) source.series.strain.push_back(load / 100);
  source.series.loops.assign(minima.size() - 1, {0, 100, 0.5});
  source.series.load = std::move(minima);
  return source;
}

Classification over_range(double range) {
  Classification found;
  found.range = range;
  return found;
}

}  // namespace

TEST_CASE("a period of several periods of the load is warned of", "[warnings]") {
  CyclesSource source = elastic({1, 1, 1});
  CHECK(warnings_of_source(source).empty());
  source.series.load_periods = 4;
  CHECK(warnings_of_source(source) ==
        std::vector<std::string>{
            "in each 10 s the load has 4 periods; give --period 2.5 to see each of its cycles"});
  // The period of the stage counts if the given one is a multiple of it.
  source.stage_period = 5;
  CHECK(warnings_of_source(source)[0].starts_with("in each 10 s the load has 2 periods; give --period 5 "));
  source.stage_period = 10;
  CHECK(warnings_of_source(source).empty());
  source.status = "interrupted";
  CHECK(warnings_of_source(source) ==
        std::vector<std::string>{"the run is interrupted: these are its cycles so far"});
}

TEST_CASE("a load that differs at the minima is warned of if the strain follows it", "[warnings]") {
  const CyclesSource source = elastic({9, 1, 1.02, 1});
  CHECK(
      warning_of_loads(source, over_range(2e-4), 1)
          .starts_with(
              "the load at the minima differs by up to 0.02 from cycle to cycle, and the strain with it; "));
  // The first minimum differs by 8, and does not count.
  CHECK(warning_of_loads(elastic({9, 1, 1, 1}), over_range(2e-4), 1).empty());
  // 0.02/100 is a tenth of this range of strain.
  CHECK(warning_of_loads(source, over_range(2.01e-3), 1).empty());
  CHECK_FALSE(warning_of_loads(source, over_range(1.99e-3), 1).empty());
  // Within 1e-4 of the range of the load, 0.5.
  CHECK(warning_of_loads(elastic({1, 1, 1.00004, 1}), over_range(0), 0).empty());
  CHECK_FALSE(warning_of_loads(elastic({1, 1, 1.00006, 1}), over_range(0), 0).empty());
}
