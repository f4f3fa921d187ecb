#include "program.hpp"

#include <catch2/catch.hpp>

using scree::test::Workspace;

TEST_CASE("accuracy prints the cheapest setting and writes table, summary and charts", "[tools]") {
  const Workspace w;
  const auto outcome = w.scree("accuracy scene.toml --out study --count 3 --coarsest 1 --tolerance 1e-2");
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  for (const char* part : {"integrator", "velocity_verlet", "observed order of",
                           "The cheapest setting within 0.01 is ", "results in study"})
    CHECK(outcome.out.find(part) != std::string::npos);
  CHECK(w.has("study/accuracy.csv"));
  CHECK(nlohmann::json::parse(w.text("study/accuracy.json"))["orders"].size() == 4);
  CHECK(nlohmann::json::parse(w.text("study/accuracy.json"))["options"] ==
        nlohmann::json({{"tolerance", 0.01}, {"coarsest", 1.0}, {"count", 3}}));
  CHECK(w.has("study/charts/worst_error.png"));
  CHECK(w.scree("accuracy scene.toml --out study").status == 2);  // already contains a study
}

TEST_CASE("accuracy refuses invalid options and writes nothing", "[tools]") {
  const Workspace w;
  for (const std::string options : {"--tolerance 0", "--count 1", "--coarsest -1", "--integrator euler"}) {
    INFO(options);
    CHECK(w.scree("accuracy scene.toml --out study " + options).status == 2);
    CHECK_FALSE(w.has("study"));
  }
  CHECK(w.scree("accuracy scene.toml --out study --set time.step=1").status == 2);
  CHECK_FALSE(w.has("study"));
}

TEST_CASE("accuracy prints control characters in the name of a law escaped", "[tools]") {
  using scree::test::discs, scree::test::with;
  const Workspace w(with(discs, "[[contact]]\n", "[[contact]]\nname = \"l\\u001b[31m\"\n"));
  // The coarser steps are too long for the contacts, which the table says.
  const auto outcome = w.scree(
      "accuracy scene.toml --out study --count 3 --coarsest 4 --integrator velocity_verlet "
      "--set contact.normal_stiffness=1e9");
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.out.find("the contacts of law 'l\\x1B[31m' allow") != std::string::npos);
  CHECK(outcome.out.find('\x1b') == std::string::npos);
  CHECK(outcome.out.find("\nvelocity_verlet") != std::string::npos);
}
