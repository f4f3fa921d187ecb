#include "program.hpp"

#include <algorithm>

using namespace scree::test;

namespace {

const std::string chain = text_of(SCREE_TEST_SOURCE "/scenarios/sound/chain.toml");

std::size_t lines_of(const std::string& text) {
  return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("response tells the modes of a chain and writes them", "[tools]") {
  const Workspace w(chain);
  const Outcome outcome = w.scree("response scene.toml --modes 3 --density 10 --out out");
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == 0);
  // Across the chain its beads are held by nothing: gravity presses them, which makes them turn over.
  CHECK(outcome.err.find("scree: warning: the packing is unstable: ") == 0);
  CHECK(outcome.out.find("8 bodies with 8 contacts") != std::string::npos);
  const nlohmann::json record = w.record("out", "response.json");
  CHECK(record["status"] == "finished");
  CHECK(record["complete"] == true);
  const double exact[] = {29.370, 87.110, 141.883};
  for (int m = 0; m < 3; ++m)
    CHECK(double(record["modes"]["mode_" + std::to_string(m + 1)]["frequency"]) ==
          Approx(exact[m]).epsilon(1e-4));
  CHECK(w.text("out/modes.csv").starts_with("kind,number,frequency [Hz],"));
  CHECK(lines_of(w.text("out/density.csv")) == 11);
#ifdef SCREE_TEST_PICTURES
  CHECK(w.has("out/charts/density.png"));
#endif
  CHECK(w.scree("response scene.toml --out out").err ==
        "scree: out: already contains a response; give another --out, or --overwrite to replace it\n");
  CHECK(w.scree("response scene.toml --out out --overwrite --quiet --near 88 --modes 1").status == 0);
  CHECK(double(w.record("out", "response.json")["modes"]["mode_1"]["frequency"]) ==
        Approx(87.110).epsilon(1e-4));
  CHECK(!w.has("out/density.csv"));
}

#ifdef SCREE_TEST_PICTURES
TEST_CASE("response draws the modes that are asked for", "[tools]") {
  const Workspace w(chain);
  const Outcome outcome = w.scree("response scene.toml --modes 2 --picture 1,2 --view x --quiet --out out");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(w.has("out/images/mode_1.png"));
  CHECK(w.has("out/images/mode_2.png"));
}
#endif

TEST_CASE("response refuses what it cannot do in one line and writes nothing", "[tools]") {
  const Workspace w(chain);
  const auto refused = [&](const std::string& arguments, const std::string& begin, const std::string& end) {
    check_refused(w, w.scree("response " + arguments), begin, end);
    CHECK(!w.has("out"));
  };
  refused("--out out", "scenario is required", "see scree response --help");
  refused("scene.toml --out out --elastic", "scene.toml: elastic constants need two parallel walls",
          "or prepare such a packing");
  refused("scene.toml --out out --fewest-contacts 9", "scene.toml: no body is held", "compress the packing");
  refused("scene.toml --out out --picture 1,x", "--picture 1,x: 'x' is not the number of a mode", "as 1,4,7");
  refused("scene.toml --out out --near -3", "--near:", "see scree response --help");
}
