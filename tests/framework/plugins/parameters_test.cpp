#include "numbers.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/nearest.hpp>
#include <scree/parameters.hpp>
#include <scree/plugin/declaration.hpp>

using scree::Error;
using scree::Parameters;
using scree::test::not_a_number;

namespace {

// One parameter of each kind and flag.
struct Author {
  double stiffness = 1, damping = 2, restitution = 3, share = 0.25;
  int shape = 1;
  bool loud = true;
  std::array<double, 3> axis = {0, 0, 1};
  scree_value ids = {};
  scree::Program load;

  static constexpr scree::About about = {"author", "", "", ""};

  void declare(scree::Declaration& d) {
    using namespace scree;
    d.number("stiffness", stiffness, "N/m", positive, "k").required();
    d.number("damping", damping, "kg/s", non_negative, "g").or_else("restitution");
    d.number("restitution", restitution, "", positive_coefficient, "r").or_else("damping");
    d.number("share", share, "", {.minimum = 0, .maximum = 1, .maximum_excluded = true}, "s");
    d.choice("shape", shape, "round|square|flat", "shape");
    d.boolean("loud", loud, "noise");
    d.vector("axis", axis, "m", "axis").optional();
    d.list("ids", ids, "", {.minimum = 1}, "ids").optional();
    d.program("load", load, "Pa", non_negative, "p").optional();
  }
};

const scree_plugin& plugin() {
  static const scree_body_force none = {};
  static const scree_plugin manifest = *scree::manifest_of<Author>(SCREE_BODY_FORCE, none);
  return manifest;
}

// The members of an author's struct, for these parameters.
Author read(const std::vector<scree_value>& values) {
  Author author;
  scree_setup setup = {};
  setup.values = values.data();
  scree::Declaration declaration(setup);
  author.declare(declaration);
  return author;
}

std::string problem(const std::string& key, const std::vector<double>& data) {
  Parameters p(plugin());
  try {
    p.set(key, data);
  } catch (const Error& error) {
    CHECK_FALSE(p.given(key));
    return error.what();
  }
  return "none";
}

std::string incomplete(const std::vector<std::string>& keys) {
  Parameters p(plugin());
  for (const std::string& key : keys) p.set(key, {0.5});
  try {
    p.check_complete();
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("values are assigned to the author's members, which otherwise keep their defaults") {
  Parameters p(plugin());
  p.set("stiffness", {5});
  p.set("restitution", {0.5});
  const std::vector<scree_value> defaults = p.values();
  const Author author = read(defaults);
  CHECK(author.stiffness == 5);
  CHECK(author.restitution == 0.5);
  CHECK(author.damping == 2);
  CHECK(author.share == 0.25);
  CHECK(author.shape == 1);
  CHECK(author.loud);
  CHECK(author.axis == std::array<double, 3>{0, 0, 1});
  CHECK(author.ids.count == 0);
  CHECK_FALSE(author.load.given());

  p.set("shape", {2});
  p.set("loud", {0});
  p.set("share", {0});
  p.set("axis", {1, 2, 3});
  p.set("ids", {4, 5});
  p.set("load", {3, 10, 20, 2});
  const std::vector<scree_value> all = p.values();
  const Author changed = read(all);
  CHECK(changed.shape == 2);
  CHECK_FALSE(changed.loud);
  CHECK(changed.share == 0);
  CHECK(changed.axis == std::array<double, 3>{1, 2, 3});
  REQUIRE(changed.ids.count == 2);
  CHECK(changed.ids.data[1] == 5);
  CHECK(changed.load(1) == 15);
}

TEST_CASE("numbers out of range are refused, with the bounds as declared") {
  CHECK(problem("stiffness", {1e-300}) == "none");
  CHECK_THAT(problem("stiffness", {0}), Catch::Contains("author.stiffness = 0 is out of range") &&
                                            Catch::Contains("number above 0 (N/m)"));
  CHECK_THAT(problem("stiffness", {-1}), Catch::Contains("out of range"));
  CHECK(problem("damping", {0}) == "none");
  CHECK(problem("restitution", {1}) == "none");
  CHECK_THAT(problem("restitution", {1.0000001}), Catch::Contains("out of range"));
  CHECK_THAT(problem("share", {1}), Catch::Contains("from 0") && Catch::Contains("below 1"));
  CHECK(problem("share", {0.999}) == "none");
  for (const double x : {not_a_number, double(INFINITY), -double(INFINITY)})
    for (const char* key : {"stiffness", "share", "shape", "loud", "axis", "ids"}) {
      const std::size_t count = std::string(key) == "axis" ? 3 : 1;
      CHECK_THAT(problem(key, std::vector<double>(count, x)), Catch::Contains("out of range"));
    }
  CHECK_THAT(problem("ids", {1, 0}), Catch::Contains("= 0 is out of range"));
}

TEST_CASE("values of the wrong shape are refused, because plug-ins read them unchecked") {
  for (const char* key : {"stiffness", "share", "shape", "loud", "axis", "ids", "load"})
    CHECK_THAT(problem(key, {}), Catch::Contains("is empty"));
  CHECK(problem("stiffness", {1, 2}) != "none");
  CHECK(problem("axis", {1, 2}) != "none");
  CHECK(problem("axis", {1, 2, 3, 4}) != "none");
  CHECK(problem("loud", {0.5}) != "none");
  CHECK(problem("shape", {0.5}) != "none");
  CHECK(problem("shape", {3}) != "none");
  CHECK(problem("shape", {-1}) != "none");
  CHECK_THAT(problem("shape", {3}), Catch::Contains("round, square, flat"));
}

TEST_CASE("programs are checked for their range of values and their shape") {
  CHECK(problem("load", {0, 5}) == "none");
  CHECK(problem("load", {1, 5, 4, 10, 0}) == "none");
  CHECK_THAT(problem("load", {1, 5, 6, 10, 0}), Catch::Contains("reaches -1") && Catch::Contains("(Pa)"));
  CHECK_THAT(problem("load", {1, 5, -6, 10, 0}), Catch::Contains("reaches -1"));
  CHECK_THAT(problem("load", {2, 5, -2, 1}), Catch::Contains("reaches -2"));
  CHECK_THAT(problem("load", {3, -3, 5, 1}), Catch::Contains("reaches -3"));
  CHECK(problem("load", {4, 0, 1, 1, 2}) == "none");
  CHECK_THAT(problem("load", {4, 0, 1, 1, -2}), Catch::Contains("reaches -2"));
  CHECK_THAT(problem("load", {0, not_a_number}), Catch::Contains("not finite"));
  // Too short or too long for their kind, of unknown kind, of zero duration, or with decreasing times.
  const std::vector<std::vector<double>> wrong = {{0},
                                                  {0, 1, 2},
                                                  {1, 5, 4, 10},
                                                  {1, 5, 4, 10, 0, 1},
                                                  {2, 5, 6},
                                                  {3, 5, 6},
                                                  {4},
                                                  {4, 0},
                                                  {4, 0, 1, 1},
                                                  {5, 1},
                                                  {-1, 1},
                                                  {0.5, 1},
                                                  {not_a_number, 1},
                                                  {2, 5, 6, 0},
                                                  {2, 5, 6, -1},
                                                  {3, 5, 6, 0},
                                                  {3, 5, 6, not_a_number},
                                                  {1, 5, 4, not_a_number, 0},
                                                  {4, 1, 1, 0, 1},
                                                  {4, not_a_number, 1}};
  for (const std::vector<double>& data : wrong) {
    CAPTURE(data);
    CHECK(problem("load", data) != "none");
  }
}

TEST_CASE("unknown keys are refused, known ones described") {
  Parameters p(plugin());
  CHECK_THROWS_AS(p.set("stifness", {1}), Error);
  CHECK_THROWS_AS(p.given("stifness"), Error);
  CHECK(p.find("stifness") == nullptr);
  REQUIRE(p.find("stiffness"));
  CHECK(std::string(p.find("stiffness")->unit) == "N/m");
  CHECK(scree::choices_of(*p.find("shape")) == std::vector<std::string>{"round", "square", "flat"});
}

TEST_CASE("required parameters must be given, and exactly one of two alternatives") {
  CHECK(incomplete({"stiffness", "damping"}) == "none");
  CHECK(incomplete({"stiffness", "restitution"}) == "none");
  CHECK_THAT(incomplete({"damping"}),
             Catch::Contains("'stiffness' is missing; add stiffness = <number above 0"));
  CHECK_THAT(incomplete({"stiffness"}), Catch::Contains("neither 'damping' nor 'restitution' is given"));
  CHECK_THAT(incomplete({"stiffness", "damping", "restitution"}),
             Catch::Contains("are both given; keep one"));
}

TEST_CASE("the closest word is suggested, if it is close") {
  const std::vector<std::string> words = {"normal_stiffness", "normal_damping", "mass", "gap"};
  CHECK(scree::nearest_word("normal_stifness", words) == "normal_stiffness");
  CHECK(scree::nearest_word("Normal-Damping", words) == "normal_damping");
  CHECK(scree::nearest_word("mas", words) == "mass");
  CHECK(scree::nearest_word("masss", words) == "mass");
  CHECK(scree::nearest_word("amss", words) == "mass");  // swapping two letters is one edit
  CHECK_FALSE(scree::nearest_word("friction", words));
  CHECK_FALSE(scree::nearest_word("", words));
  CHECK_FALSE(scree::nearest_word("mass", {}));
}
