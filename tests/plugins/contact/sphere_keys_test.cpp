#include "sphere_values.hpp"

#include <catch2/catch.hpp>

// Which keys `sphere_path_independent` takes with each normal force.

using namespace scree;
using namespace scree::test;

namespace {

// The refusal of keys, or nothing.
std::string refusal(const Values& values, int dimension = 3) {
  try {
    LawBatch("sphere_path_independent", values, dimension);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the law for spheres takes the keys of its normal force and refuses others in one line",
          "[sphere]") {
  const Values linear = {{"normal_stiffness", {100}}, {"restitution", {0.5}}},
               hertz = sphere_values(true, 0.3);
  const auto with = [](Values values, const std::string& key, double value) {
    values.push_back({key, {value}});
    return values;
  };
  using Catch::Contains;
  CHECK(refusal(linear).empty());
  CHECK(refusal(hertz).empty());
  CHECK(refusal({{"normal", {1}}, {"youngs_modulus", {1e7}}, {"poissons_ratio", {0}}}).empty());
  for (const std::string key :
       {"youngs_modulus", "poissons_ratio", "other_youngs_modulus", "other_poissons_ratio", "friction"})
    CHECK_THAT(refusal(with(linear, key, 0.1)),
               Contains(key + " belongs to normal = \"hertz\"; remove it, or set normal = \"hertz\""));
  for (const std::string key : {"normal_stiffness", "normal_damping", "tangential_stiffness",
                                "tangential_damping", "static_friction", "dynamic_friction"})
    CHECK_THAT(refusal(with(hertz, key, 0.1)),
               Contains(key + " belongs to normal = \"linear\"; remove it, or set normal = \"linear\""));
  CHECK_THAT(refusal({}),
             Contains("normal = \"linear\" needs normal_stiffness; give it, or set normal = \"hertz\""));
  for (const Values& values : {Values{{"normal_stiffness", {100}}}, with(linear, "normal_damping", 1)})
    CHECK_THAT(refusal(values), Contains("either normal_damping or restitution; give one of them"));
  CHECK_THAT(refusal({{"normal", {1}}, {"youngs_modulus", {1e7}}}),
             Contains("normal = \"hertz\" needs youngs_modulus and poissons_ratio; give both"));
  CHECK_THAT(refusal(with(linear, "static_friction", 0.5)),
             Contains("friction needs tangential_stiffness above 0"));
  const Values rough = with(with(linear, "static_friction", 0.5), "tangential_stiffness", 80);
  CHECK(refusal(rough).empty());
  CHECK_THAT(refusal(with(linear, "dynamic_friction", 0.3)),
             Contains("dynamic_friction is above static_friction, which is 0; give static_friction too"));
  CHECK_THAT(refusal(with(rough, "dynamic_friction", 0.6)),
             Contains("dynamic_friction is above static_friction; give at most the static value"));
  CHECK_THAT(refusal(linear, 2), Contains("a law of spheres") && Contains("dimension = 3"));
}

TEST_CASE("the dashpots of spheres begin and end with a jump or as the fourth root of the overlap",
          "[sphere]") {
  for (const bool hertz : {false, true})
    for (const double tension : {0.0, 1.0}) {
      Values values = sphere_values(hertz, 0.3);
      values.push_back({"tension", {tension}});
      const LawBatch law("sphere_path_independent", values);
      const double power = hertz ? 0.25 : 0;
      CHECK(law.instance().onset_power == power);
      CHECK(law.instance().parting_power == (tension == 0 ? power : 1));  // 1: the force is 0 before
    }
}
