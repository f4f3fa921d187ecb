#include "error_line.hpp"
#include "plugins/false_law.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/closed_forms.hpp>

using Catch::StartsWith;
using scree::test::FalseLaw;

namespace {

constexpr scree_encounter encounter = {1, 0.01, 1, 1};

// What closed_forms() says about a law that states these forms.
template <std::uint32_t (*forms)(scree_closed_form*)>
std::string refusal_of_forms() {
  FalseLaw law;
  law.law.closed_forms = [](const void*, const scree_encounter*, scree_closed_form* all, std::uint32_t) {
    return forms(all);
  };
  return scree::test::error_line([&] { scree::closed_forms(law.configured(), encounter); });
}

std::uint32_t too_many(scree_closed_form*) { return 4000000000u; }
std::uint32_t nameless(scree_closed_form* forms) {
  forms[0] = {"contact_time", "s", "t", 1};
  forms[1] = {nullptr, "", "r", 1};
  return 2;
}
template <int tenths>
std::uint32_t contact_time(scree_closed_form* forms) {
  forms[0] = {"contact_time", "s", "t", tenths < -10 ? NAN : 0.1 * tenths};
  return 1;
}
std::uint32_t endless(scree_closed_form* forms) {
  forms[0] = {"contact_time", "s", "t", INFINITY};
  return 1;
}

}  // namespace

TEST_CASE("the closed forms of a law are those that it states") {
  const FalseLaw law;
  const auto forms = scree::closed_forms(law.configured(), encounter);
  REQUIRE(forms.size() == 2);
  CHECK(std::string(forms[0].name) == "contact_time");
  CHECK(forms[1].value == 1);
  CHECK(refusal_of_forms<endless>() == "no error");
}

TEST_CASE("a law that states more closed forms than there is room for, or one without a name, is refused") {
  CHECK_THAT(refusal_of_forms<too_many>(),
             StartsWith("plug-in false_law: states 4000000000 closed forms where there is "));
  CHECK_THAT(refusal_of_forms<nameless>(),
             StartsWith("plug-in false_law: a closed form has no name, unit or formula; "));
}

TEST_CASE("a law whose contact time is not above 0 is refused by name") {
  CHECK_THAT(refusal_of_forms<contact_time<0>>(),
             StartsWith("plug-in false_law: contact_time = 0 s is not above 0, for a "));
  CHECK_THAT(refusal_of_forms<contact_time<-1>>(),
             StartsWith("plug-in false_law: contact_time = -0.1 s is not above 0"));
  CHECK_THAT(refusal_of_forms<contact_time<-11>>(),
             StartsWith("plug-in false_law: contact_time = nan s is not above 0"));
}
