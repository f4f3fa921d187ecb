#include "plan_support.hpp"

#include <catch2/catch.hpp>

#include <scree/parameters.hpp>
#include <scree/plugin/program.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

namespace {

using Numbers = std::vector<double>;

std::size_t index_of(const scree_plugin& plugin, const std::string& key) {
  std::size_t k = 0;
  while (k < plugin.parameter_count && plugin.parameters[k].key != key) ++k;
  REQUIRE(k < plugin.parameter_count);
  return k;
}

const scree_parameter& parameter_of(const Parameters& parameters, const std::string& key) {
  return parameters.plugin().parameters[index_of(parameters.plugin(), key)];
}

Numbers numbers_of(const Parameters& parameters, const std::string& key) {
  const auto values = parameters.values();
  const scree_value& value = values[index_of(parameters.plugin(), key)];
  return {value.data, value.data + value.count};
}

}  // namespace

TEST_CASE("control characters in the name of a plug-in are refused in one line", "[scenario]") {
  CHECK(refusal(discs, {"contact.plugin=\"en\\u0001ergy\""}) ==
        "--set contact.plugin=\"en\\u0001ergy\": the name 'en\\x01ergy' has control characters; "
        "see scree describe for the names");
}

TEST_CASE("parameters of every type are read as the plug-in takes them", "[scenario]") {
  const Plan plan = plan_of(
      std::string(discs) +
          "[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0.5, -5]\nnormal = [0, 1]\ncontrol = 'displacement'\n"
          "displacement = { amplitude = 2e-3, frequency_hz = 50 }\n"
          "[[probe]]\nplugin = 'profile'\naxis = 'y'\nbins = 4\nlow = -1\nhigh = 1\n"
          "[[probe]]\nplugin = 'particles'\nids = [3, 1]\nevery = 1e-5\n",
      {"probe.profile.every=1e-5"});
  const Parameters& floor = plan.scene.boundaries[1].parameters;
  // In two dimensions a vector has two numbers in the file and three for the plug-in.
  CHECK(numbers_of(floor, "point") == Numbers{0.5, -5, 0});
  CHECK(numbers_of(floor, "normal") == Numbers{0, 1, 0});
  const scree_parameter& control = parameter_of(floor, "control");
  const std::vector<std::string> words = choices_of(control);
  CHECK(words.at(std::size_t(numbers_of(floor, "control")[0])) == "displacement");
  const Numbers program = numbers_of(floor, "displacement");
  CHECK(Program({.data = program.data(), .count = program.size()})(0.005) ==
        Approx(2e-3));  // a quarter of a period
  CHECK(numbers_of(plan.probes[1].parameters, "bins") == Numbers{4});
  CHECK(numbers_of(plan.probes[2].parameters, "ids") == Numbers{3, 1});
  CHECK(numbers_of(plan.scene.laws[0].parameters, "normal_stiffness") == Numbers{1e4});
}

TEST_CASE("a parameter of another type or out of its range is refused at its value", "[scenario]") {
  const std::string floor = "[[boundary]]\nplugin = 'plane'\nnormal = [0, 1]\npoint = ";  // 27 to 30
  CHECK(refusal(discs + floor + "[0, 1, 2]\n")
            .starts_with("scene.toml:30:9: boundary[1].point has 3 elements"));
  CHECK(refusal(discs + floor + "[0, -5]\ncontrol = 'displacment'\n").find("is none of the choices") !=
        std::string::npos);
  CHECK(
      refusal(discs, {"contact.normal_stiffness='soft'"}).ends_with("is a string (\"soft\"); give a number"));
  CHECK(refusal(discs, {"contact.normal_stiffness=-1"}).ends_with("give a number above 0 (N/m)"));
}
