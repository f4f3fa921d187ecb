#include "program.hpp"

#include <sstream>

#include <catch2/catch.hpp>

using scree::test::Workspace;

TEST_CASE("bench appends a row per call to a CSV with one header, and prints phases", "[tools]") {
  const Workspace w;
  const auto first = w.scree("bench scene.toml --seconds 0.01 --repeats 1 --csv bench.csv");
  INFO(first.err);
  CHECK(first.status == 0);
  for (const char* part : {"9 particles", "ms per step", "neighbours", "gather", "law", "reduce", "audit"})
    CHECK(first.out.find(part) != std::string::npos);
  CHECK(w.scree("bench scene.toml --threads 2 --seconds 0.01 --repeats 1 --csv bench.csv").status == 0);
  std::istringstream csv(w.text("bench.csv"));
  std::string header, one, two, more;
  std::getline(csv, header), std::getline(csv, one), std::getline(csv, two);
  CHECK(header.starts_with("version,scene,particles,contacts,threads,time,steps,repeats,"));
  CHECK(one.find(",scene,9,") != std::string::npos);
  CHECK(std::count(one.begin(), one.end(), ',') == std::count(header.begin(), header.end(), ','));
  CHECK_FALSE(std::getline(csv, more));
  const std::string cut = w.text("bench.csv");
  w.write("cut.csv", cut.substr(0, cut.size() - 1));
  CHECK(w.scree("bench scene.toml --seconds 0.01 --repeats 1 --csv cut.csv").status == 0);
  CHECK(w.text("cut.csv").starts_with(cut));
  w.write("old.csv", "scene,contacts_s\n");
  const auto refused = w.scree("bench scene.toml --seconds 0.01 --repeats 1 --csv old.csv");
  CHECK(refused.status != 0);
  CHECK(refused.err.find("old.csv: has other columns") != std::string::npos);
}

TEST_CASE("bench restarts a scene that ends, and starts at the given time", "[tools]") {
  const Workspace w;
  // 8 steps to --start, 9 for warm-up and 3 times 9 timed.
  const std::string call = "bench scene.toml --set time.duration=8e-5 --set time.step=1e-5 --repeats 2";
  const auto first = w.scree(call + " --steps 9");
  INFO(first.err);
  CHECK(first.status == 0);
  CHECK(first.out.find("2 repeats of 9 steps, starting at t = 1e-05 s") != std::string::npos);
  const auto later = w.scree(call + " --steps 2 --start 5e-5");
  CHECK(later.out.find("2 repeats of 2 steps, starting at t = 7e-05 s") != std::string::npos);
  CHECK(w.scree(call + " --start 8e-5").status == 2);
  const auto never = w.scree(call + " --start 9e-5");
  CHECK(never.status == 2);
  CHECK(never.err.find("the scene ends at 8e-05 s; give a smaller --start") != std::string::npos);
}

TEST_CASE("bench accepts its scenes by name and suggests the nearest", "[tools]") {
  const Workspace w;
  const auto known = w.scree("bench discs-16 --seconds 0.01 --repeats 1");
  CHECK(known.status == 0);
  CHECK(known.out.find("ns per contact") != std::string::npos);
  const auto outcome = w.scree("bench discs-61");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("did you mean 'discs-16'?") != std::string::npos);
}
