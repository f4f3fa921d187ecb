#include "layer_support.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

// Probes that read few bodies mark each that they read.

using namespace scree;
using namespace scree::test;

namespace {

// A view in which all that changes in a run is NaN for bodies that are not listed.
class PoisonedView {
 public:
  PoisonedView(const scree_view& view, const ListedBodies& listed) : view_(view) {
    std::vector<bool> known(view.body_count, false);
    for (const std::uint32_t i : listed.value()) known[i] = true;
    for (auto* const vectors : {&view_.position, &view_.velocity, &view_.spin, &view_.force, &view_.torque})
      for (scree_column& column : *vectors) poison(column, known);
    for (scree_column& column : view_.orientation) poison(column, known);
  }
  const scree_view& get() const { return view_; }

 private:
  void poison(scree_column& column, const std::vector<bool>& known) {
    if (!column) return;
    std::vector<double>& copy = columns_.emplace_back();
    for (std::size_t i = 0; i < known.size(); ++i)
      copy.push_back(known[i] ? column[i] : std::numeric_limits<double>::quiet_NaN());
    column = {copy.data(), 1};
  }

  scree_view view_;
  std::vector<std::vector<double>> columns_;
};

struct Case {
  const char* plugin;
  Values values;
  std::size_t bodies;
};

const Values along_y = {{"axis", {1}}};

Values joined(Values values, const Values& more) {
  values.insert(values.end(), more.begin(), more.end());
  return values;
}

// The lattice has two bodies at each height.
const std::vector<Case> cases = {
    {"particles", {{"ids", {3, 17}}}, 2},
    {"body_energy", {{"ids", {3, 17, 5}}}, 3},
    {"difference", {{"ids", {1, 20}}}, 2},
    {"orientation", {{"ids", {4}}}, 1},
    {"mean_squared_displacement", {{"ids", {2, 7}}}, 2},
    {"layer", joined(along_y, {{"at", {0.35}}, {"half_width", {0.06}}}), 2},
    {"strain", joined(along_y, {{"low", {0.15}}, {"high", {0.85}}, {"half_width", {0.02}}}), 4},
    {"profile", joined(along_y, {{"bins", {3}}, {"low", {0.1}}, {"high", {0.7}}}), 12},
};

bool equal(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k] != b[k] && !(std::isnan(a[k]) && std::isnan(b[k]))) return false;
  return true;
}

}  // namespace

TEST_CASE("probes that list bodies read no others", "[probe]") {
  Scene scene = lattice_in_box(3, 1);
  scene.orientations = true;
  for (Body& b : scene.bodies) b.spin = {{0.1, 0.2 * double(b.id), 0.3}};
  for (const Case& c : cases) {
    INFO(c.plugin);
    Simulation s(scene);
    Probe probe = probe_of(c.plugin, c.values, 3);
    CHECK(probe.check(SimulationView(s, probe.needs()).get()) == c.bodies);
    CHECK(!probe.listed_bodies());  // reads all to start
    probe.observe(SimulationView(s, probe.needs()).get());
    REQUIRE(probe.listed_bodies());
    CHECK(probe.listed_bodies()->size() == c.bodies);
    s.run(100, [] { return true; });
    const SimulationView view(s, probe.needs());
    Probe other = resumed(probe, c.plugin, c.values, s);
    const PoisonedView poisoned(view.get(), probe.listed_bodies());
    const std::vector<double> row = other.sample(view.get());
    CHECK(equal(probe.sample(poisoned.get()), row));
    CHECK(std::any_of(row.begin(), row.end(), [](double x) { return std::isfinite(x) && x != 0; }));
  }
}

TEST_CASE("probes of all bodies list none", "[probe]") {
  const Simulation s(lattice_in_box(3, 1));
  for (const char* plugin : {"mean_squared_displacement", "structure", "autocorrelation"}) {
    Probe probe = probe_of(plugin, {}, 3);
    INFO(plugin);
    const SimulationView view(s, probe.needs());
    CHECK(probe.check(view.get()) == s.scene().bodies.size());
    probe.observe(view.get());
    CHECK(!probe.listed_bodies());
  }
}

TEST_CASE("probes that add up totals read no bodies but in their parts", "[probe]") {
  Simulation s(lattice_in_box(3, 1));
  s.run(20, [] { return true; });
  for (const char* plugin : {"momentum", "contacts", "stress"}) {
    Probe probe = probe_of(plugin, {}, 3);
    INFO(plugin);
    const SimulationView start(s, probe.view_needs(), NAN, probe.listed_bodies());
    CHECK(probe.check(start.get()) == 0);
    CHECK(start.get().contact_count == 0);
    probe.sample(start.get(), {}, [&] { return s.totals_of(probe); });
    const SimulationView walls(s, probe.view_needs(), NAN, probe.listed_bodies());
    CHECK(walls.get().position[0].data == nullptr);
    CHECK(probe.sample(walls.get(), {}, [&] { return s.totals_of(probe); }) ==
          probe_of(plugin, {}, 3).sample(SimulationView(s, probe.needs()).get()));
  }
}
