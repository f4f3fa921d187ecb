#include "changed_state.hpp"
#include "support.hpp"
#include "temporary_folder.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include <scree/files/text.hpp>
#include <scree/quasi_static/follow.hpp>
#include <scree/run/run.hpp>
#include <scree/spectrum/measurement.hpp>
#include <scree/state_file/state_file.hpp>

namespace {

using namespace scree;
namespace fs = std::filesystem;

constexpr const char* falling = R"(
time.step = 2e-5
particles.lattice = { kind = "simple_cubic", count = [3, 3, 3], gap = 0.01 }
particles.radius = 0.005
particles.random_velocity = 0.1
material = [{ name = "m", density = 2000 }]
body_force = [{ plugin = "gravity", acceleration = [0, 0, -9.81] }]
stage = [{ name = "a", duration = 6e-4 }, { name = "b", duration = 4e-4, set.lid.stress = 200 }]
expect = [{ requirement = "balance", quantity = "energy_residual", at_most = 1 }]
contact = [{ plugin = "hertz_mindlin", youngs_modulus = 1e6, poissons_ratio = 0.3, restitution = 0.6, friction = 0.3 }]
[[boundary]]
plugin = "periodic"
axes = "xy"
lower = [-0.001, -0.001, 0]
upper = [0.0305, 0.0305, 1]
[[boundary]]
plugin = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
[[boundary]]
name = "lid"
plugin = "plane"
point = [0, 0, 0.032]
normal = [0, 0, -1]
control = "stress"
stress = 100
area = 9e-4
mass = 0.1
viscosity = 1
[[probe]]
plugin = "energy"
every = 1e-4
[[probe]]
plugin = "mean_squared_displacement"
window = 2e-4
ids = [2, 5]
every = 2e-4
[[probe]]
plugin = "orientation"
ids = [3]
every = 2e-4
[[probe]]
plugin = "touching"
ids = [3, 4]
every = 2e-4
[[probe]]
plugin = "particles"
ids = [2]
every = 2e-5
[[probe]]
plugin = "lock_in"
of = "particles.z_2"
frequency_hz = 5000
periods = 4
detrend = "period_average"
every = 2e-4
)";

// Results that were interrupted: their directory, their state, and how they go on.
struct Interrupted {
  fs::path directory, state_name;
  State state;
  std::function<void(const fs::path& out, const std::atomic<bool>* stop)> resume;
};

PluginHost& host() {
  static PluginHost host({SCREE_FUZZ_PLUGINS});
  return host;
}

Interrupted interrupted(const fs::path& directory, const fs::path& state_name) {
  return {directory, state_name, state_file::read_state(directory / state_name), {}};
}

Interrupted interrupted_run(const test::TemporaryFolder& folder) {
  const fs::path out = folder / "run";
  scenario::Plan plan = scenario::read_plan(folder.write("run.toml", falling), {}, host());
  plan.checkpoint.every_time = 5e-4;
  plan.checkpoint.final_state = false;
  run::RunOptions options;
  options.out = out;
  run::run_plan(plan, options);
  const fs::path half = fs::path("checkpoint") / "step_000000000000025.h5";
  fs::remove(out / "checkpoint/step_000000000000050.h5");
  Interrupted made = interrupted(out, half);
  made.resume = [](const fs::path& to, const std::atomic<bool>* stop) {
    run::RunOptions again;
    again.out = to;
    again.on_warning = [](const std::string&) {};
    again.stop = stop;
    run::resume_run(again, {}, host());
  };
  return made;
}

Interrupted interrupted_sweep(const test::TemporaryFolder& folder) {
  const scenario::Plan plan =
      scenario::read_plan(SCREE_FUZZ_SCENARIOS "/sound/chain.toml",
                          {"spectrum.from_hz=100", "spectrum.to_hz=140", "spectrum.step_hz=2",
                           "spectrum.sweep.periods=400", "spectrum.sweep.adaptive=true"},
                          host(), {spectrum::spectrum_table()});
  std::atomic<bool> stop = false;
  spectrum::MeasurementOptions options;
  options.out = folder / "sweep";
  options.methods = {spectrum::Method::linear, spectrum::Method::sweep};
  options.stop = &stop;
  options.on_progress = [&](double share, double, const std::string& what) {
    stop = share > 0.1 && what.starts_with("sweep");
  };
  spectrum::measure(plan, options);
  Interrupted made = interrupted(options.out, "state.h5");
  made.resume = [](const fs::path& to, const std::atomic<bool>* now) {
    spectrum::MeasurementOptions again;
    again.out = to;
    again.stop = now;
    spectrum::resume_measurement(again, host());
  };
  return made;
}

Interrupted interrupted_load(const test::TemporaryFolder& folder) {
  const scenario::Plan plan = scenario::read_plan(
      SCREE_FUZZ_SCENARIOS "/mcnamara2008/biaxial.toml",
      {"stage.cycles.cycles=3", "time.step=1e-3", "stage.compress.until.kinetic_over_elastic=1e-6"}, host());
  std::atomic<bool> stop = false;
  quasi_static::FollowOptions options;
  options.out = folder / "load";
  options.increments = 8;
  options.stop = &stop;
  options.on_progress = [&](double share, double, const std::string&) { stop = share > 0.4; };
  quasi_static::follow(plan, options);
  Interrupted made = interrupted(options.out, "state.h5");
  made.resume = [](const fs::path& to, const std::atomic<bool>* now) {
    quasi_static::FollowOptions again;
    again.out = to;
    again.stop = now;
    quasi_static::resume_following(again, host());
  };
  return made;
}

// Every end but success and an error with a cure is a finding: what goes on with other numbers may blow up.
// The program prints errors in one line.
void check_end(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    fuzz::check_refusal(Error(files::one_line(error.what(), 4000)));
  }
}

}  // namespace

// States with a right seal and wrong content: the input changes numbers, types, shapes and texts of the state
// of a run, a sweep or a quasi-static load that was interrupted, which then goes on.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::TemporaryFolder folder;
  static const std::vector<Interrupted> all = {interrupted_run(folder), interrupted_sweep(folder),
                                               interrupted_load(folder)};
  if (size == 0) return 0;
  const Interrupted& chosen = all[data[0] % all.size()];
  const fs::path out = folder / "out";
  fs::remove_all(out);
  fs::copy(chosen.directory, out, fs::copy_options::recursive);
  bool texts = false;
  const State changed = fuzz::changed(chosen.state, {data + 1, size - 1}, texts);
  try {
    state_file::write_state(out / chosen.state_name, changed);
  } catch (const std::invalid_argument&) {
    return 0;  // a shape that no file can have
  }
  // Another scenario may take any time.
  const std::atomic<bool> stop = texts || &chosen != &all[0];
  check_end([&] { chosen.resume(out, &stop); });
  return 0;
}
