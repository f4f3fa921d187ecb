#include "program.hpp"

using namespace scree::test;

namespace {

const std::string charted_scene =
    std::string(discs) +
    "[[chart]]\nname = 'energies'\nprobe = 'energy'\ny = ['kinetic_translation', 'work']\nlog_x = true\n";

}  // namespace

TEST_CASE("chart draws the charts of a run again, changed, in another format or those of another file",
          "[tools]") {
  const Workspace w(charted_scene);
  const Outcome run = w.run();
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  REQUIRE(w.has("out/charts/energies.png"));
  const std::string first = w.text("out/charts/energies.png");
  CHECK(w.scree("chart out --set chart.energies.log_x=false").out == "out/charts/energies.png\n");
  CHECK(w.text("out/charts/energies.png") != first);
  CHECK(w.scree("chart out").status == 0);
  CHECK(w.text("out/charts/energies.png") == first);
  CHECK(w.scree("chart out --set chart.energies.format=svg").out == "out/charts/energies.svg\n");
  CHECK_THAT(w.text("out/charts/energies.svg"), Catch::Contains("<title>energies</title>"));
  CHECK(w.scree("chart out --set 'chart[0].format=pdf'").status == 0);
  CHECK(w.text("out/charts/energies.pdf").starts_with("%PDF-"));
  w.write("more.toml", "[[chart]]\nname = 'stages'\nprobe = 'energy'\ny = 'residual'\n");
  CHECK(w.scree("chart out --scenario more.toml --out own").out == "own/stages.png\n");
  const Outcome again = w.scree("chart out --scenario more.toml --out own");
  CHECK(again.status == 2);
  CHECK(again.err == "scree: own/stages.png: is there already; give another --out, or --overwrite\n");
  CHECK(w.scree("chart out --scenario more.toml --out own --overwrite").status == 0);
  // All charts of a run that are drawn again are listed, so that --overwrite removes them.
  CHECK(w.run("--overwrite").status == 0);
  CHECK_FALSE(w.has("out/charts/energies.svg"));
}

TEST_CASE("chart draws the tables of a study", "[tools]") {
  const Workspace w;
  std::filesystem::create_directory(w / "study");
  w.write("study/density.csv", "from [Hz],density [1/Hz],kind\n10,1,a\n20,3,b\n30,2,c\n");
  w.write("study/scenario.toml", "[[chart]]\nname = 'd'\nprobe = 'density'\nx = 'from'\ny = 'density'\n");
  CHECK(w.scree("chart study").out == "study/charts/d.png\n");
  const Outcome words = w.scree("chart study --set chart.d.y=kind");
  CHECK(words.status == 1);
  CHECK(words.err.starts_with("scree: study/density.csv:2:"));
  CHECK_THAT(words.err, Catch::Contains("; choose a column of numbers"));
}

TEST_CASE("chart refuses what it cannot draw, and render names it", "[tools]") {
  const Workspace w(charted_scene);
  REQUIRE(w.run().status == 0);
  const auto refused = [&](const std::string& arguments, const std::string& line) {
    const Outcome outcome = w.scree(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.starts_with("scree: " + line));
  };
  refused("chart out --set chart.energies.y=wrk",
          "--set chart.energies.y=wrk: no column 'wrk'; did you mean 'work'?");
  refused("chart out --set chart.energies.log=true",
          "--set chart.energies.log=true: unknown key 'log' in [[chart]]; ");
  refused("chart out --set chart.energies.format=jpg", "--set chart.energies.format=jpg: ");
  refused(
      "render out --charts --set chart.energies.log_x=false",
      "--charts: charts have their own verb; give scree chart DIRECTORY, with the same --set and --scenario");
  const Workspace empty;
  CHECK(empty.scree("chart .").err.starts_with("scree: .: contains no series/*.csv and no *.csv; "));
}
