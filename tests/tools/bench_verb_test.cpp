#include "program.hpp"

#include <sstream>

#include <catch2/catch.hpp>

using scree::test::Workspace;

TEST_CASE("bench adds a row per call to a CSV with one header, and tells phases") {
  const Workspace w;
  const auto first = w.scree("bench scene.toml --seconds 0.01 --repeats 1 --csv bench.csv");
  INFO(first.err);
  CHECK(first.status == 0);
  for (const char* part :
       {"9 particles", "ms a step", "ns a contact", "neighbours", "gather", "law", "reduce", "books"})
    CHECK(first.out.find(part) != std::string::npos);
  CHECK(w.scree("bench scene.toml --threads 2 --seconds 0.01 --repeats 1 --csv bench.csv").status == 0);
  std::istringstream csv(w.text("bench.csv"));
  std::string header, one, two, more;
  std::getline(csv, header), std::getline(csv, one), std::getline(csv, two);
  CHECK(header.starts_with("scene,precision,particles,contacts,threads,steps,s_per_step,"));
  CHECK(one.starts_with("scene,double,9,"));
  CHECK(std::count(one.begin(), one.end(), ',') == std::count(header.begin(), header.end(), ','));
  CHECK_FALSE(std::getline(csv, more));
  w.write("old.csv", "scene,contacts_s\n");
  const auto refused = w.scree("bench scene.toml --seconds 0.01 --repeats 1 --csv old.csv");
  CHECK(refused.status != 0);
  CHECK(refused.err.find("old.csv: has other columns") != std::string::npos);
}

TEST_CASE("bench knows its scenes by name and suggests the nearest") {
  const Workspace w;
  CHECK(w.scree("bench discs-16 --seconds 0.01 --repeats 1").status == 0);
  const auto outcome = w.scree("bench discs-61");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("did you mean 'discs-16'?") != std::string::npos);
}
