#include <catch2/catch.hpp>

#include <scree/nearest.hpp>

using namespace scree;

TEST_CASE("only close words are suggested") {
  const std::vector<std::string> keys = {"friction", "restitution", "youngs_modulus", "plugin", "a", "step"};
  CHECK(nearest_word("frction", keys) == "friction");
  CHECK(nearest_word("rfiction", keys) == "friction");
  CHECK(nearest_word("Youngs-Modulus", keys) == "youngs_modulus");
  CHECK(nearest_word("youngs", keys) == "youngs_modulus");
  CHECK(nearest_word("friction_coefficient", keys) == "friction");
  CHECK(nearest_word("setp", keys) == "step");
  CHECK(nearest_word("friction", keys) == "friction");
  CHECK_FALSE(nearest_word("damping", keys));
  CHECK_FALSE(nearest_word("b", keys));
  CHECK_FALSE(nearest_word("", keys));
  CHECK_FALSE(nearest_word("friction", {}));
  const std::vector<std::string> parts = {"normal_stiffness", "static_friction", "dynamic_friction",
                                          "frictions"};
  CHECK(nearest_word("stiffness", parts) == "normal_stiffness");
  CHECK(nearest_word("friction", {"static_friction", "dynamic_friction"}) == "static_friction");
  CHECK(nearest_word("friction", parts) == "frictions");
  CHECK(nearest_word("wall_friction", keys) == "friction");
  CHECK_FALSE(nearest_word("mess", {"stiff_ness", "stiffness"}));
  CHECK_FALSE(nearest_word("x", {"spin_x"}));
  CHECK(nearest_word("bact", {"cat", "bat", "bait"}) == "bat");
}
