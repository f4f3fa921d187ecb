#include "scenes.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <catch2/catch.hpp>

#include <scree/plugin/probe.hpp>
#include <scree/probes.hpp>
#include <scree/state_transfer.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// What a probe of these tests may leave out.
struct Minimal {
  static constexpr About about = {"minimal", "", "", ""};
  void declare(Declaration&) {}
  void describe(scree_probe_instance& instance) const { instance.column_count = 1; }
  ColumnName column(std::uint32_t) const { return {"value", "m"}; }
  void sample(const scree_view&, const double*, double* row) const { *row = 7; }
};

// Lock-in amplifier: amplitude and phase of the position of the first wall at a frequency, from sums that are
// updated at every step.
struct WallLockIn : Minimal {
  double frequency = 0;
  static constexpr About about = {"lock_in", "", "", ""};
  void declare(Declaration& d) { d.number("frequency_hz", frequency, "Hz", positive, "").required(); }
  void describe(scree_probe_instance& instance) const {
    instance.column_count = 2;
    instance.state_width = 3;
  }
  ColumnName column(std::uint32_t c) const {
    return c == 0 ? ColumnName{"amplitude", "m"} : ColumnName{"phase", "rad"};
  }
  void observe(const scree_view& view, double* state) const {
    if (view.step == 0) return;  // whole periods have as many steps as observations
    const double angle = 2 * std::numbers::pi * frequency * view.time;
    state[0] += view.planes[0].point[0] * std::sin(angle);
    state[1] += view.planes[0].point[0] * std::cos(angle);
    state[2] += 1;
  }
  void sample(const scree_view&, const double* state, double* row) const {
    row[0] = 2 * std::hypot(state[0], state[1]) / state[2];
    row[1] = std::atan2(state[1], state[0]);
  }
};

// Counts the steps since the last observation, for each body.
struct PerBody : Minimal {
  static constexpr About about = {"per_body", "", "", ""};
  std::uint64_t state_size(const scree_view& view) const { return 2 * view.body_count; }
  std::string start(const scree_view& view, double* state) const {
    for (std::uint64_t i = 0; i < view.body_count; ++i) state[2 * i + 1] = view.mass[i];
    return view.body_count == 5 ? "five bodies are too many; remove one" : "";
  }
};

// Columns of the names, separated by '|'.
struct Named : Minimal {
  static constexpr About about = {"named", "", "", ""};
  int which = 0;
  void declare(Declaration& d) { d.choice("which", which, "a|b|c|d|e|f|g|h", ""); }
  void describe(scree_probe_instance& instance) const { instance.column_count = 2; }
  ColumnName column(std::uint32_t c) const {
    if (c == 1) return {"fine", "kg m^2/s^2"};
    static const ColumnName bad[] = {{"a,b", ""}, {"a\nb", ""},  {"a\"b", ""},  {"", ""},
                                     {"x", "m,"}, {"fine", "m"}, {"time", "s"}, {"stage", ""}};
    return bad[which];
  }
};

// Writes one number too many: of the state at the start or when observing, or of a row.
struct Careless : Minimal {
  static constexpr About about = {"careless", "", "", ""};
  int where = 0;
  void declare(Declaration& d) { d.choice("where", where, "start|observe|row|huge", ""); }
  void describe(scree_probe_instance& instance) const { instance.column_count = 1; }
  std::uint64_t state_size(const scree_view&) const { return where == 3 ? std::uint64_t(1) << 60 : 2; }
  std::string start(const scree_view&, double* state) const {
    if (where == 0) state[2] = 1;
    return "";
  }
  void observe(const scree_view&, double* state) const {
    if (where == 1) state[2] = 1;
  }
  void sample(const scree_view&, const double*, double* row) const { row[where == 2] = 7; }
};

// Throws where it is asked for the size of its state.
struct Sizeless : Minimal {
  static constexpr About about = {"sizeless", "", "", ""};
  void describe(scree_probe_instance& instance) const { instance.column_count = 1; }
  std::uint64_t state_size(const scree_view&) const { throw std::runtime_error("boo"); }
};

template <class Author>
Probe probe_of(const Values& values = {}, int dimension = 3) {
  Parameters p(*manifest_of<Author>(SCREE_PROBE, probe_interface<Author>));
  for (const auto& [key, value] : values) p.set(key, value);
  return Probe(p, dimension);
}

const Values row_law = {{"normal_stiffness", {5000}}, {"normal_damping", {0}}};

Scene bodies_in_a_row(int count) {
  std::vector<Body> bodies;
  for (int i = 0; i < count; ++i) bodies.push_back(body(i + 1, 0.01, 1 + i, {{0.05 * i, 0, 0}}));
  return scene(3, 1e-3, bodies, row_law);
}

constexpr double amplitude = 0.003, frequency = 4, phase = 0.7;

// A wall that oscillates along x about x = −1 m; a step is 1/250 of its period.
Scene shaken() {
  Scene s = bodies_in_a_row(1);
  const double start = amplitude * std::sin(phase);
  add_boundary(s, "plane",
               {{"point", {-1 + start, 0, 0}},
                {"normal", {1, 0, 0}},
                {"displacement", {Program::sine, 0, amplitude, frequency, phase}}});
  return s;
}

}  // namespace

TEST_CASE("a probe that observes sums over all steps: a lock-in finds amplitude and phase of a wall",
          "[probe]") {
  Simulation s(shaken());
  Probe lock_in = probe_of<WallLockIn>({{"frequency_hz", {frequency}}});
  REQUIRE(lock_in.observes());
  const auto observe = [&] { lock_in.observe(SimulationView(s, lock_in.needs()).get()); };
  observe();
  for (int k = 0; k < 750; ++k) s.step(), observe();
  // Over whole periods the sums over other frequencies vanish, that of the mean of 1 m within 750 roundings.
  const std::vector<double> row = lock_in.sample(SimulationView(s, 0).get());
  CHECK(lock_in.state()[2] == 750);
  CHECK(row[0] == Approx(amplitude).epsilon(0).margin(750 * 2.2e-16));
  CHECK(row[1] == Approx(phase).epsilon(0).margin(750 * 2.2e-16 / amplitude));
}

TEST_CASE("a probe without observe, start and state has none", "[probe]") {
  const Simulation s(bodies_in_a_row(1));
  Probe probe = probe_of<Minimal>();
  CHECK_FALSE(probe.observes());
  const SimulationView view(s, 0);
  CHECK(probe.sample(view.get()) == std::vector<double>{7});
  probe.observe(view.get());
  CHECK(probe.state().empty());
  CHECK(probe_interface<Minimal>.observe == nullptr);
}

TEST_CASE("the width of a state may depend on the scene", "[probe]") {
  const Simulation s(bodies_in_a_row(3));
  Probe probe = probe_of<PerBody>();
  CHECK(probe.state().empty());
  probe.check(SimulationView(s, 0).get());
  CHECK(probe.state().empty());
  probe.sample(SimulationView(s, 0).get());
  CHECK(std::vector<double>(probe.state().begin(), probe.state().end()) ==
        std::vector<double>{0, 1, 0, 2, 0, 3});
}

TEST_CASE("a probe that writes beyond its state or row is named", "[probe]") {
  const Simulation s(bodies_in_a_row(1));
  const SimulationView view(s, 0);
  const auto observe_and_sample = [&](int where) {
    Probe probe = probe_of<Careless>({{"where", {double(where)}}});
    probe.observe(view.get());
    probe.sample(view.get());
  };
  const std::string state =
      "plug-in careless: writes beyond the 2 numbers of its state; declare as many as it writes";
  CHECK_THROWS_WITH(observe_and_sample(0), state);
  CHECK_THROWS_WITH(observe_and_sample(1), state);
  CHECK_THROWS_WITH(observe_and_sample(2),
                    "plug-in careless: writes beyond the 1 number of its row; declare as many as it writes");
  CHECK_THROWS_WITH(observe_and_sample(3),
                    Catch::Contains("is larger than the limit of 1000000000; keep less"));
}

TEST_CASE("an exception that the size of a state throws is reported with the name of the probe", "[probe]") {
  const Simulation s(bodies_in_a_row(1));
  CHECK_THROWS_WITH(
      probe_of<Sizeless>().check(SimulationView(s, 0).get()),
      Catch::StartsWith("plug-in sizeless: its function state_size threw an exception (boo); "));
}

TEST_CASE("a probe refuses a scene with a text of its own", "[probe]") {
  const Simulation s(bodies_in_a_row(5));
  CHECK_THROWS_WITH(probe_of<PerBody>().check(SimulationView(s, 0).get()),
                    "probe per_body: five bodies are too many; remove one");
}

TEST_CASE("a probe whose columns a CSV file cannot hold is refused by name", "[probe]") {
  for (int which = 0; which < 5; ++which) {
    INFO(which);
    CHECK_THROWS_WITH(
        probe_of<Named>({{"which", {double(which)}}}),
        "plug-in named: the name or unit of column 1 is empty or has characters that a CSV file "
        "cannot hold; name columns in snake_case");
  }
  CHECK_THROWS_WITH(probe_of<Named>({{"which", {5.0}}}), Catch::Contains("two columns are named 'fine'"));
  for (const auto& [which, name] : {std::pair(6, "time"), std::pair(7, "stage")})
    CHECK_THROWS_WITH(
        probe_of<Named>({{"which", {double(which)}}}),
        Catch::Contains("a column is named '" + std::string(name) + "', as one that every series has"));
}

TEST_CASE("a view has materials, inertia, step, energies and contacts as far as they are needed", "[probe]") {
  Scene sc = bodies_in_a_row(2);
  sc.bodies[1].position = {{0.0199, 0, 0}};
  sc.bodies[1].material = 1;
  sc.materials = {"glass", "steel"};
  sc.law_of = {0, 0, 0, 0};
  sc.spin = true;
  const Simulation s(sc);
  const SimulationView all(s, SCREE_NEEDS_CONTACTS | SCREE_NEEDS_ENERGY), few(s, 0);
  CHECK(all.get().step_length == 1e-3);
  REQUIRE(all.get().material_count == 2);
  CHECK(all.get().material_names[all.get().material[1]] == std::string("steel"));
  CHECK(all.get().inertia[1] == sc.bodies[1].inertia);
  CHECK(all.get().contact_count == 1);
  CHECK(all.get().energy->elastic_normal == Approx(0.5 * 5000 * 1e-8));
  CHECK(few.get().contact_count == 0);
  for (const double scree_energy::*e : {&scree_energy::kinetic_translation, &scree_energy::residual})
    CHECK(std::isnan(few.get().energy->*e));
  Scene without = sc;
  without.audit = false;
  const Simulation silent(without);
  CHECK(std::isnan(SimulationView(silent, SCREE_NEEDS_ENERGY).get().energy->work));
}

TEST_CASE("a view has periods, images and the lengths between walls, now and at the start", "[probe]") {
  Scene sc = bodies_in_a_row(1);
  sc.bodies[0].position = {{0.25, 0.5, 0.5}};
  sc.bodies[0].velocity = {{-5, 0, 0}};
  add_boundary(sc, "periodic", {{"axes", {0}}, {"lower", {0, 0, 0}}, {"upper", {2, 0, 0}}});
  add_boundary(sc, "plane", {{"point", {0, 0, -1}}, {"normal", {0, 0, 1}}});  // below the next one
  add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  add_boundary(sc, "plane",
               {{"point", {0, 0, 4}}, {"normal", {0, 0, -1}}, {"displacement", {Program::ramp, 0, 1, 0.1}}});
  add_boundary(sc, "plane", {{"point", {0, -1, 0}}, {"normal", {0, 1, 0}}});
  Simulation s(sc);
  run(s, 100);
  const SimulationView seen(s, 0);
  const scree_view& view = seen.get();
  CHECK(view.period[0] == 2);
  CHECK(view.period[2] == 0);
  CHECK(view.image[0][0] == -1);
  CHECK(view.image[2][0] == 0);
  CHECK(unwrapped_position(view, 0)[0] == Approx(0.25 - 0.5).epsilon(100 * 2.2e-16 * 4));
  CHECK(view.length[0] == 2);
  CHECK(std::isnan(view.length[1]));  // a floor without a lid
  CHECK(view.length_at_start[2] == 4);
  CHECK(view.length[2] / view.length_at_start[2] - 1 == Approx(-0.25).epsilon(1e-12));
  const Simulation open(bodies_in_a_row(1));
  CHECK(SimulationView(open, 0).get().image[0] == nullptr);
  CHECK(std::isnan(SimulationView(open, 0).get().length[0]));
}

TEST_CASE("a list of bodies finds each id, in the order of the list", "[probe]") {
  const double ids[] = {3, 1, 3, 2};
  const BodyList list = {.ids = {ids, 4}}, every_second = {.ids = {ids, 4}, .stride = 2};
  const Simulation s(bodies_in_a_row(3));
  const SimulationView view(s, 0);
  double indices[4];
  CHECK(list.find(view.get(), indices) == "");
  const auto all_found = [&] {
    for (std::uint64_t k = 0; k < 4; ++k)
      if (view.get().id[list.index(view.get(), indices, k)] != list.id(k)) return false;
    return true;
  };
  CHECK(all_found());
  for (const double wrong : {1e16, -1.0, 3.0, 0.5, std::nan(""), double(INFINITY), -double(INFINITY)}) {
    indices[1] = wrong;  // as a state file of a stranger may have it
    CHECK(all_found());
  }
  CHECK(every_second.size() == 2);
  CHECK(every_second.id(1) == 3);
  const Simulation two(bodies_in_a_row(2));
  CHECK_THROWS(list.index(SimulationView(two, 0).get(), indices, 0));
  CHECK(list.find(SimulationView(two, 0).get(), indices) ==
        "a body with the id 3 does not exist; bodies without an id are numbered from 1, after the largest id "
        "given");
}

TEST_CASE("what a probe kept is refused if it has another size than its plug-in expects") {
  const Simulation s(bodies_in_a_row(1));
  const SimulationView view(s, 0);
  Probe saved = probe_of<Careless>({{"where", {2}}});
  saved.observe(view.get());
  scree::State state;
  saved.transfer(scree::StateTransfer::saving_to(state).below("probe"));
  const std::size_t size = GENERATE(std::size_t(0), std::size_t(1), std::size_t(2), std::size_t(3));
  state.put("probe/state", {std::vector<double>(size), {size}, "1"});
  Probe restored = probe_of<Careless>({{"where", {2}}});
  restored.transfer(scree::StateTransfer::restoring_from(state).below("probe"));
  if (size == 2)
    CHECK_NOTHROW(restored.check_restored(view.get()));
  else
    CHECK_THROWS_WITH(restored.check_restored(view.get()), Catch::Matchers::Contains("instead of 2"));
}
