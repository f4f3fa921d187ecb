#include "faulty_law.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include <scree/plugin_checks/law_checks.hpp>

using namespace scree;
using plugin_checks::Check;

namespace {

// The checks that a law with a mistake fails.
plugin_checks::Checks failures(int fault) {
  plugin_checks::Checks checks =
      plugin_checks::check_law(test::faulty(test::Fault(fault)),
                               test::host_of_laws().locate("faulty", SCREE_CONTACT_LAW), test::checked_pair);
  std::erase_if(checks, [](const Check& check) { return check.verdict != Check::Verdict::failed; });
  return checks;
}

// Their names, without the dimension.
std::set<std::string> failed_checks(int fault) {
  std::set<std::string> failed;
  for (const Check& check : failures(fault)) failed.insert(check.name.substr(0, check.name.find(", ")));
  return failed;
}

void check_all(const std::string& name, const test::Values& values) {
  const Parameters law = test::parameters(name, SCREE_CONTACT_LAW, values);
  INFO(name);
  for (const auto& [key, value] : values) UNSCOPED_INFO(key << " " << value[0]);
  for (const Check& check :
       plugin_checks::check_law(law, test::host().locate(name, SCREE_CONTACT_LAW), {.speed = 0.1})) {
    INFO(check.name << ": " << check.detail);
    CHECK(check.verdict != Check::Verdict::failed);
  }
}

}  // namespace

TEST_CASE("a law without a mistake passes all checks", "[plugin_checks]") {
  CHECK(failed_checks(0) == std::set<std::string>{});
}

TEST_CASE("each mistake of a law fails the checks that are meant for it", "[plugin_checks]") {
  const std::map<int, std::string> expected = {
      {1, "force and couple change sign when the bodies change their names"},
      {2, "force and couple rotate with the contact"},
      {3, "no energy is created"},
      {4, "the energy balance of impacts closes as the step falls"},
      {5, "derivatives agree with finite differences"},
      {6, "finite results at the limits of the parameters"},
      {7, "the closed form restitution is that of a head-on impact"},
      {8, "the closed form contact_time is that of a head-on impact"},
      {9, "forces are along the normal"}};
  for (const auto& [fault, check] : expected) {
    const std::set<std::string> failed = failed_checks(fault);
    INFO("mistake " << fault << " must fail: " << check);
    CHECK(failed.count(check) == 1);
    // A wrong force also changes the outcome of impacts; a mistake elsewhere changes nothing else.
    if (fault >= 4 && fault < 8) CHECK(failed.size() == 1);
  }
}

// The elastic energy that is stated is 1.2 times that of the spring, whatever the step: what remains of the
// error is 1, but for a part of the order of the step, at most 2 pi / 100, since steps do not meet the
// largest overlap.
TEST_CASE("an error that does not fall with the step is told by what is left of it and of the bound",
          "[plugin_checks]") {
  const plugin_checks::Checks failed = failures(4);
  REQUIRE(failed.size() == 2);  // 2D and 3D
  for (const Check& check : failed)
    CHECK_THAT(check.detail,
               Catch::Matches("[0-9.]+ of the energy turned over falls to (0\\.9[4-9]|1\\.00) of "
                              "itself from t_c/100 to t_c/400; at most 0\\.33"));
}

TEST_CASE("a law that ends or holds the program fails the checks that meet it", "[plugin_checks]") {
  const char* const expected[] = {"an exception (boo)",
                                  "an exception (of unknown type)",
                                  "the law ends the program (signal 11, Segmentation fault)",
                                  "the law ends the program (signal 6, Aborted)",
                                  "the law ends the program (status 0)",
                                  "the law ends the program (status 0)",
                                  "no end within 2 s",
                                  "the law ends the program (signal 11, Segmentation fault)"};
  PluginHost& host = test::host_of_laws();
  for (int deed = 0; deed < 8; ++deed) {
    Parameters law(host.find("hostile", SCREE_CONTACT_LAW));
    law.set("deed", {double(deed)});
    INFO("deed " << deed);
    const plugin_checks::Checks checks =
        plugin_checks::check_law(law, host.locate("hostile", SCREE_CONTACT_LAW), {}, 2);
    const auto first_failed = std::find_if(checks.begin(), checks.end(), [](const Check& check) {
      return check.verdict == Check::Verdict::failed;
    });
    REQUIRE(first_failed != checks.end());
    CHECK(first_failed->name == (deed == 7 ? "closed forms are usable" : "symmetries, 2D"));
    CHECK(first_failed->detail == expected[deed]);
  }
}

TEST_CASE("the laws for discs pass all checks", "[plugin_checks][disc]") {
  for (const std::string name : {"disc_angular", "disc_corrected"})
    for (const bool area : {false, true})
      for (const double friction : {0.0, 0.2})
        check_all(name, {{"normal", {area ? 1.0 : 0.0}},
                         {"normal_stiffness", {area ? 5e4 : 5000}},
                         {"normal_damping", {1}},
                         {"tangential_stiffness", {4000}},
                         {"tangential_damping", {0.5}},
                         {"friction", {friction}}});
}

TEST_CASE("the law for spheres passes all checks", "[plugin_checks][sphere]") {
  for (const double friction : {0.0, 0.2}) {
    const test::Values linear = {{"normal_stiffness", {5000}},
                                 {"tangential_stiffness", {1400}},
                                 {"tangential_damping", {0.5}},
                                 {"static_friction", {friction}}};
    for (const auto& damping : {std::pair("restitution", 0.8), std::pair("normal_damping", 0.1)}) {
      test::Values values = linear;
      values.push_back({damping.first, {damping.second}});
      check_all("sphere_path_independent", values);
    }
    check_all("sphere_path_independent", {{"normal", {1}},
                                          {"youngs_modulus", {1e7}},
                                          {"poissons_ratio", {0.3}},
                                          {"restitution", {0.8}},
                                          {"friction", {friction}}});
  }
}
