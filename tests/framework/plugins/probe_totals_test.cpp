#include "scenes.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/plugin/probe.hpp>
#include <scree/probes.hpp>

// What the host asks of probes with totals.

using namespace scree;
using namespace scree::test;

namespace {

// Counts bodies, with a description that a test chooses.
struct Counting {
  double totals = 1, largest = 0, passes = 1, needs = 0, beyond = 0;
  bool refuses = false;

  static constexpr About about = {"counting", "", "", ""};
  void declare(Declaration& d) {
    d.number("totals", totals, "", any_number, "");
    d.number("largest", largest, "", any_number, "");
    d.number("passes", passes, "", any_number, "");
    d.number("needs", needs, "", any_number, "");
    d.number("beyond", beyond, "", any_number, "writes to the place behind the totals");
    d.boolean("refuses", refuses, "to start");
  }
  void describe(scree_probe_instance& instance) const {
    instance.column_count = 2;
    instance.needs = std::uint32_t(needs);
    instance.total_count = std::uint32_t(totals);
    instance.largest_count = std::uint32_t(largest);
    instance.passes = std::uint32_t(passes);
  }
  ColumnName column(std::uint32_t c) const { return {c == 0 ? "bodies" : "seen", ""}; }
  std::string start(const scree_view&, double*) const { return refuses ? "not here; go" : ""; }
  void accumulate(const scree_view& part, std::uint32_t, double* t) const {
    t[0] += double(part.part_end - part.part_begin);
    if (beyond > 0) t[1] = 7;
  }
  void sample(const scree_view& view, const double*, double* row) const {
    row[0] = view.totals[0];
    row[1] = double(view.body_count + view.contact_count) + (view.id ? 1 : 0) + (view.position[0] ? 1 : 0);
  }
};
struct Observing : Counting {
  static constexpr About about = {"observing", "", "", ""};
  void observe(const scree_view&, double*) const {}
};
struct Forgetful {
  static constexpr About about = {"forgetful", "", "", ""};
  void declare(Declaration&) {}
  void describe(scree_probe_instance& instance) const {
    instance.column_count = instance.total_count = instance.passes = 1;
  }
  ColumnName column(std::uint32_t) const { return {"value", ""}; }
  void sample(const scree_view&, const double*, double*) const {}
};

template <class Author>
Probe made(const Values& values = {}) {
  Parameters p(*manifest_of<Author>(SCREE_PROBE, probe_interface<Author>));
  for (const auto& [key, value] : values) p.set(key, value);
  return Probe(p, 3);
}

Simulation three_bodies() {
  std::vector<Body> bodies;
  for (int i = 0; i < 3; ++i) bodies.push_back(body(i + 1, 0.1, 1, {{0.19 * i, 0, 0}}));
  return Simulation(scene(3, 1e-5, bodies, {{"normal_stiffness", {5000}}, {"normal_damping", {0}}}));
}

}  // namespace

TEST_CASE("totals that do not fit together are refused when a probe is configured", "[probe]") {
  const auto problem = [](const Values& values) {
    try {
      made<Counting>(values);
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(problem({}).empty());
  CHECK_THAT(problem({{"totals", {0}}}), Catch::Contains("but no totals; set total_count"));
  CHECK_THAT(problem({{"largest", {2}}}), Catch::Contains("more largest values than totals"));
  CHECK_THAT(problem({{"passes", {0}}}), Catch::Contains("has totals without a pass"));
  CHECK_THAT(problem({{"passes", {4e9}}}), Catch::Contains("take fewer"));
  CHECK_THAT(problem({{"totals", {1e9}}}), Catch::Contains("take fewer"));
  CHECK_THROWS_WITH(made<Observing>(), Catch::Contains("leave out one of the two"));
  CHECK_THROWS_WITH(made<Forgetful>(), Catch::Contains("has totals but no accumulate function; give it one"));
}

TEST_CASE("a probe with totals starts before they are added up, and its rows see no bodies", "[probe]") {
  const Simulation s = three_bodies();
  const SimulationView view(s, SCREE_NEEDS_CONTACTS);
  Probe refusing = made<Counting>({{"refuses", {1}}});
  bool added = false;
  const auto add = [&] {
    added = true;
    return std::vector<double>{5};
  };
  CHECK_THROWS_WITH(refusing.sample(view.get(), {}, add), "probe counting: not here; go");
  CHECK(!added);
  Probe probe = made<Counting>();
  CHECK(probe.sample(view.get(), {}, add) == std::vector<double>{5, 0});
  CHECK(probe.sample(view.get()) == std::vector<double>{3, 0});
  CHECK(probe.sample(view.get(), {}, [&] { return s.totals_of(probe); }) == std::vector<double>{3, 0});
}

TEST_CASE("a probe that writes beyond its totals is named", "[probe]") {
  const Simulation s = three_bodies();
  Probe probe = made<Counting>({{"beyond", {1}}});
  CHECK_THROWS_WITH(
      probe.sample(SimulationView(s, 0).get()),
      "plug-in counting: writes beyond the 1 number of its totals; declare as many as it writes");
}
