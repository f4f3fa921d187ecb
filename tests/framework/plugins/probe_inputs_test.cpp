#include "scenes.hpp"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/plugin/probe.hpp>
#include <scree/probes.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Sums one column of another probe, and writes that sum and another column.
struct Reader {
  InputColumn summed, shown;
  static constexpr About about = {"reader", "", "", ""};
  void declare(Declaration& d) {
    d.input("shown", shown, "").optional();
    d.input("summed", summed, "").required();
  }
  void describe(scree_probe_instance& instance) const {
    instance.column_count = 2;
    instance.state_width = 2;
    instance.observe_every = 0.25;
  }
  ColumnName column(std::uint32_t c) const { return {c ? "shown" : "sum", c ? shown.unit : summed.unit}; }
  std::string start(const scree_view& view, double* state) const {
    state[0] = std::isnan(summed.value(view)) ? 0 : NAN;  // no column has a value yet
    return "";
  }
  void observe(const scree_view& view, double* state) const { state[0] += summed.value(view); }
  void sample(const scree_view& view, const double* state, double* row) const {
    row[0] = state[0];
    row[1] = shown.value(view);
  }
};

Parameters reader() { return Parameters(*manifest_of<Reader>(SCREE_PROBE, probe_interface<Reader>)); }

Scene one_body() {
  return scene(3, 1e-3, {body(1, 0.01, 1, {})}, {{"normal_stiffness", {1}}, {"normal_damping", {0}}});
}

}  // namespace

TEST_CASE("a probe has names, units and values of the columns that it reads", "[probe]") {
  Parameters p = reader();
  p.set_input("summed", "box.strain", "m/m");
  p.set_input("shown", "energy.work", "J");
  Probe probe(p, 3);
  CHECK(probe.names() == std::vector<std::string>{"sum", "shown"});
  CHECK(probe.units() == std::vector<std::string>{"m/m", "J"});
  CHECK(probe.observe_every() == 0.25);
  const Simulation s(one_body());
  const SimulationView view(s, 0);
  for (const double strain : {0.5, 0.25}) {
    const double values[] = {strain, 7};
    probe.observe(view.get(), values);
  }
  const double now[] = {1, 8};
  CHECK(probe.sample(view.get(), now) == std::vector<double>{0.75, 8});
}

TEST_CASE("a column may be given anew, or left out if it is optional", "[probe]") {
  Parameters p = reader();
  p.set_input("summed", "a.b", "m");
  p.set_input("summed", "c.d", "s");
  REQUIRE(p.inputs().size() == 1);
  CHECK(p.inputs()[0].name == std::string("c.d"));
  p.set_input("shown", "e.f", "kg");
  const Parameters copy = p;
  p.set_input("shown", "g.h", "N");
  CHECK(copy.inputs()[1].name == std::string("e.f"));
  CHECK(p.inputs()[1].unit == std::string("N"));
}

TEST_CASE("a column of another probe that is no column, or of no probe, is refused", "[probe]") {
  Parameters p = reader();
  CHECK_THROWS_WITH(p.set("summed", {0}),
                    "reader.summed is a number; give \"<probe>.<column>\" of another probe");
  CHECK_THROWS_WITH(Probe(p, 3), Catch::Contains("'summed' is missing"));
  Parameters box(host().find("box", SCREE_BOUNDARY));
  CHECK_THROWS_WITH(box.set_input("gap", "a.b", ""),
                    Catch::Contains("box.gap is no column of a probe; give a number"));
}

TEST_CASE("a view knows the end of the run where the host does", "[probe]") {
  const Simulation s(one_body());
  CHECK(SimulationView(s, 0, 3).get().end_time == 3);
  CHECK(std::isnan(SimulationView(s, 0).get().end_time));
}
