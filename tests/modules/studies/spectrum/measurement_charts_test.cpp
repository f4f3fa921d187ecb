#include "bench.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::spectrum;
using namespace scree::test;

TEST_CASE("a chart that cannot be written leaves the spectrum whole", "[spectrum]") {
  Bench bench(Chain().text("from_hz = 80\nto_hz = 95\nstep_hz = 0.5\nlinear.fewest_contacts = 1\n"));
  bench.options.methods = {Method::linear};
  bench.options.on_progress = [&](double, double, const std::string&) {
    std::filesystem::create_directories(bench.options.out / "charts/particles_z_8.png/in_the_way");
  };
  std::vector<std::string> warnings;
  bench.options.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  const Measurement m = measure(bench.plan, bench.options);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].starts_with("chart 'particles.z_8' was not drawn: "));
  CHECK(bench.has("charts/particles_z_1.png"));
  CHECK(bench.has("peaks.csv"));
  CHECK(text_of(bench.options.out / "spectrum.json").find("\"finished\"") != std::string::npos);
}
