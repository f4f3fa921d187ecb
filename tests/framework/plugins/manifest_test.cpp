#include "plugins/manifest.hpp"

#include "plugins/false_law.hpp"

#include <cstddef>

#include <catch2/catch.hpp>

#include <scree/plugin/declaration.hpp>

using scree::manifest_problem;
using scree::test::FalseLaw;

namespace {

// The problem of a manifest after a change; empty if there is none.
template <class Change>
std::string problem_after(const Change& change) {
  FalseLaw law;
  change(law);
  return manifest_problem(&law.plugin).value_or("");
}

std::string problem_of(const scree_parameter& parameter) {
  return problem_after([&](FalseLaw& law) {
    law.plugin.parameters = &parameter;
    law.plugin.parameter_count = 1;
  });
}

}  // namespace

TEST_CASE("a whole manifest has no problem") {
  CHECK(problem_after([](FalseLaw&) {}).empty());
}

TEST_CASE("a manifest without a name, text, interface or function is refused") {
  CHECK(problem_after([](FalseLaw& l) { l.plugin.name = nullptr; }) == "its manifest has no name; set it");
  for (const char* scree_plugin::*text :
       {&scree_plugin::summary, &scree_plugin::equation, &scree_plugin::source})
    CHECK(problem_after([&](FalseLaw& l) { l.plugin.*text = nullptr; }) ==
          "its manifest has no summary, equation or source; set it");
  CHECK(problem_after([](FalseLaw& l) { l.plugin.interface = nullptr; }) ==
        "its manifest has no interface; set it");
  CHECK(problem_after([](FalseLaw& l) { l.law.closed_forms = nullptr; }) ==
        "its manifest has no function in its interface that is not optional; set it");
}

TEST_CASE("a manifest of a wrong size, kind or number of parameters is refused") {
  CHECK(problem_after([](FalseLaw& l) {
          l.plugin.struct_size = 40;
        }).starts_with("was built with other headers "));
  CHECK(problem_after([](FalseLaw& l) {
          l.plugin.kind = 99;
        }).starts_with("contains a plug-in of an unknown kind 99; "));
  CHECK(problem_after([](FalseLaw& l) { l.plugin.parameter_count = 1; }) ==
        "its manifest has no table of parameters; set it");
  CHECK(problem_after([](FalseLaw& l) {
          l.plugin.parameter_count = 4000000000u;
        }).starts_with("declares 4000000000 parameters, more than the limit of "));
}

TEST_CASE("a probe that was built before columns had meanings is used, and one of another size is not") {
  const auto problem = [](std::uint32_t size) {
    return problem_after([&](FalseLaw& l) {
      static scree_probe probe;
      probe = {};
      probe.struct_size = size;
      probe.configure = [](const scree_setup*, void*, scree_probe_instance*) { return 0; };
      probe.column = [](const void*, std::uint32_t, char*, char*) {};
      probe.start = [](const void*, const scree_view*, double*, char*, std::size_t) { return 0; };
      probe.sample = [](const void*, const scree_view*, const double*, double*) {};
      l.plugin.kind = SCREE_PROBE;
      l.plugin.interface = &probe;
    });
  };
  CHECK(problem(sizeof(scree_probe)).empty());
  CHECK(problem(offsetof(scree_probe, meaning)).empty());
  CHECK(problem(offsetof(scree_probe, sample))
            .starts_with("has the interface of another version of a probe; "));
}

TEST_CASE("a parameter without a key, unit, text or choices is refused, and one of an unknown type") {
  scree_parameter good = {};
  good.key = "k", good.unit = "", good.doc = "d", good.choices = "a|b", good.excludes = "k";
  CHECK(problem_of(good).empty());
  scree_parameter p = good;
  p.key = nullptr;
  CHECK(problem_of(p) == "its manifest has no key of a parameter; set it");
  p = good, p.unit = nullptr;
  CHECK(problem_of(p) == "its manifest has no unit or doc of the parameter 'k'; set it");
  p = good, p.type = SCREE_CHOICE, p.choices = nullptr;
  CHECK(problem_of(p) == "its manifest has no choices of the parameter 'k'; set it");
  p = good, p.type = 99;
  CHECK(problem_of(p).starts_with("its parameter 'k' has the unknown type 99; "));
  p = good, p.type = SCREE_INPUT;
  CHECK(problem_of(p) == "its parameter 'k' is a column of a probe, which only probes read; remove it");
  p = good, p.excludes = "other";
  CHECK(problem_of(p).starts_with("its parameter 'k' excludes 'other', which it does not have; "));
}

TEST_CASE("a default outside its range is refused, unless the parameter must be given or may be absent") {
  scree_parameter p = {};
  p.key = "k", p.unit = "", p.doc = "d";
  p.minimum = 0, p.maximum = 1, p.default_value = 2;
  CHECK(problem_of(p).starts_with("its parameter 'k' has the default 2, outside its range; "));
  p.flags = SCREE_REQUIRED;
  CHECK(problem_of(p).empty());
  p.flags = SCREE_OPTIONAL;
  CHECK(problem_of(p).empty());
}

TEST_CASE("a parameter with a name that a scenario cannot give, or gives to every plug-in, is refused") {
  scree_parameter p = {};
  p.unit = "", p.doc = "d";
  for (const char* key : {"", "a b", "a.b", "ä", "k\n", "\"k\""}) {
    p.key = key;
    CHECK_THAT(problem_of(p), Catch::Contains("is not a key of a scenario; "));
  }
  for (const char* key : {"plugin", "name", "between"}) {
    p.key = key;
    CHECK_THAT(problem_of(p), Catch::Contains("that a scenario gives to every contact law; rename it"));
  }
  for (const char* key : {"k", "youngs_modulus", "K-1", "every", "material"}) {
    p.key = key;
    CHECK(problem_of(p).empty());
  }
}

TEST_CASE("parameters for which a declaration has no room are counted, and refused") {
  scree::Declaration declaration;
  double member = 0;
  int choice = 0;
  for (std::uint32_t k = 0; k <= scree::Declaration::capacity; ++k)
    declaration.number("k", member, "", scree::any_number, "d").optional();
  declaration.choice("c", choice, "a|b", "d");
  CHECK(declaration.count() == scree::Declaration::capacity + 2);
  CHECK(problem_after([&](FalseLaw& law) {
          law.plugin.parameters = declaration.table();
          law.plugin.parameter_count = declaration.count();
        }).starts_with("declares 66 parameters, more than the limit of 64; "));
}

TEST_CASE("a parameter that is declared twice is refused") {
  scree_parameter both[2] = {};
  for (scree_parameter& p : both) p.key = "k", p.unit = "", p.doc = "d";
  CHECK(problem_after([&](FalseLaw& law) {
          law.plugin.parameters = both;
          law.plugin.parameter_count = 2;
        }) == "declares the parameter 'k' twice; rename one");
}
