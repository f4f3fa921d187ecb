#include "chain.hpp"
#include "linear.hpp"
#include "pulse.hpp"
#include "sweep.hpp"

#include <string>
#include <string_view>
#include <utility>

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>

using namespace scree;
using namespace scree::spectrum;
using namespace scree::test;

namespace {

constexpr double press = 0.1;  // (N)

// A column of beads between a floor and a lid of the mass of a bead on which a force presses.
std::string pressed_chain(const std::string& spectrum) {
  const double overlap = press / Chain::stiffness;
  double top = 0;
  std::string beads;
  for (int i = 1; i <= Chain::beads; ++i) {
    top += (i == 1 ? Chain::radius : 2 * Chain::radius) - overlap;
    beads += fmt::format("[[particle]]\nid = {}\nposition = [0, 0, {}]\nradius = {}\nmass = {}\n", i, top,
                         Chain::radius, Chain::mass);
  }
  return fmt::format(
             "[time]\nstep = {}\n[[material]]\nname = 'sphere'\ndensity = 2000\n"
             "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = {}\nnormal_damping = 0.05\n"
             "[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\ndisplacement = 0\n"
             "[[boundary]]\nplugin = 'plane'\nname = 'lid'\npoint = [0, 0, {}]\nnormal = [0, 0, -1]\ncontrol = 'force'\n"
             "force = {}\nmass = 1e-3\nviscosity = 0.02\nsuperposed = 0\n"
             "[[body_force]]\nplugin = 'background_damping'\ntranslational = 0.02\n"
             "[[probe]]\nplugin = 'particles'\nids = [1, 8]\n[[probe]]\nplugin = 'walls'\nwalls = [2]\n",
             Chain::step, Chain::stiffness, top + Chain::radius - overlap, press) +
         beads +
         "[spectrum]\namplitude = 1e-8\nlinear.fewest_contacts = 1\nobserve = ['particles.z_1', 'particles.z_8', 'walls.displacement_z_2', 'walls.velocity_2']\n" +
         spectrum;
}

}  // namespace

TEST_CASE("three methods agree where a force presses a wall, driven by either wall", "[spectrum]") {
  const auto drive = GENERATE("floor.displacement", "lid.superposed");
  const scenario::Plan plan = driven_plan_of(pressed_chain(fmt::format(
      "drive = '{}'\nfrom_hz = 40\nto_hz = 120\nstep_hz = 20\npulse.decay = 1e-6\nsweep.periods = 150\nsweep.analysed_periods = 50\n",
      drive)));
  const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
  const MethodSpectrum linear = linear_spectrum(start), pulse = pulse_spectrum(start);
  Sweep sweep(start);
  sweep.run([] {});
  const MethodSpectrum swept = sweep.spectra().at(0);
  CHECK(sweep.points()[0].drive == Approx(1e-8).epsilon(1e-9));
  for (const std::size_t c : {0u, 1u, 2u, 3u})
    for (std::size_t k = 0; k < linear.frequencies.size(); ++k) {
      CAPTURE(drive, c, linear.frequencies[k], linear.columns[c].response[k], pulse.columns[c].response[k]);
      const double size = std::abs(linear.columns[c].response[k]);
      // (ωh)²/24 = 6e-5 of the frequency at a Q below 20, and γ h/m = 2.5e-3 of the damping.
      CHECK(std::abs(pulse.columns[c].response[k] - linear.columns[c].response[k]) < 3e-3 * size);
      CHECK(std::abs(swept.columns[c].response[k] - pulse.columns[c].response[k]) < 1e-4 * size);
    }
}

// Discs instead of the planes.
std::string between_discs(std::string scene) {
  for (const auto& [plane, disc] : {std::pair{"plugin = 'plane'", "plugin = 'disc'\nradius = 0.1"},
                                    {"'walls'", "'surfaces'"},
                                    {"walls = [2]", "surfaces = [2]"}})
    for (std::size_t at = 0; (at = scene.find(plane)) != std::string::npos;)
      scene.replace(at, std::string_view(plane).size(), disc);
  return scene;
}

// Derivatives of the same forces: round-off. The pulse has the round-off of positions of 1e-2 m, 1e-18 m,
// over amplitudes of 1e-8 m, in 1e5 steps at random.
TEST_CASE("surfaces drive a chain, and are pressed, as planes", "[spectrum]") {
  const auto drive = GENERATE("floor.displacement", "lid.superposed");
  const std::string planes = pressed_chain(
      fmt::format("drive = '{}'\nfrom_hz = 40\nto_hz = 120\nstep_hz = 20\npulse.decay = 1e-6\n", drive));
  const auto spectra = [](std::string scene) {
    const std::size_t observed = scene.find(", 'walls.displacement_z_2', 'walls.velocity_2'");
    scene.erase(observed, std::string_view(", 'walls.displacement_z_2', 'walls.velocity_2'").size());
    const scenario::Plan plan = driven_plan_of(scene);
    const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
    return std::pair{linear_spectrum(start), pulse_spectrum(start)};
  };
  const auto [linear, pulse] = spectra(planes);
  const auto [linear_of_discs, pulse_of_discs] = spectra(between_discs(planes));
  for (const std::size_t c : {0u, 1u})
    for (std::size_t k = 0; k < linear.frequencies.size(); ++k) {
      CAPTURE(drive, c, linear.frequencies[k]);
      const double size = std::abs(linear.columns[c].response[k]);
      CHECK(size > 0);
      CHECK(std::abs(linear_of_discs.columns[c].response[k] - linear.columns[c].response[k]) < 1e-9 * size);
      CHECK(std::abs(pulse_of_discs.columns[c].response[k] - pulse.columns[c].response[k]) < 1e-6 * size);
    }
}

TEST_CASE("with the time step of the run the linear method is the stepped sweep", "[spectrum]") {
  const bool massless = GENERATE(false, true);
  // ωh = 0.2 at 160 Hz.
  std::string text =
      with(pressed_chain(
               "drive = 'floor.displacement'\nfrom_hz = 40\nto_hz = 160\nstep_hz = 40\nsweep.periods = 300\n"
               "sweep.analysed_periods = 50\nsweep.detrend = 'polynomial'\n"),
           fmt::format("step = {}\n", Chain::step), "step = 2e-4\n");
  if (massless)
    text = with(text, "control = 'force'\nforce = 0.1\nmass = 1e-3\nviscosity = 0.02\nsuperposed = 0\n",
                "control = 'massless'\nforce = 0.1\nspeed_limit = 1\n");
  const auto linear_with = [&](const std::string& step) {
    const scenario::Plan plan = driven_plan_of(text + "linear.step = '" + step + "'\n");
    return linear_spectrum({plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()});
  };
  const scenario::Plan plan = driven_plan_of(text);
  const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
  Sweep sweep(start);
  sweep.run([] {});
  const MethodSpectrum swept = sweep.spectra().at(0), run = linear_with("run"), limit = linear_with("limit");
  double furthest = 0;
  for (const std::size_t c : {0u, 1u, 2u, 3u})
    for (std::size_t k = 0; k < run.frequencies.size(); ++k) {
      CAPTURE(massless, c, run.frequencies[k], swept.columns[c].response[k], run.columns[c].response[k],
              limit.columns[c].response[k]);
      const double size = std::abs(swept.columns[c].response[k]);
      // Drag alone makes modes 0.02/(2π m) = 3.2 Hz wide, so that transients fall to 2e-7 in 250 periods of
      // 160 Hz.
      CHECK(std::abs(run.columns[c].response[k] - swept.columns[c].response[k]) < 1e-6 * size);
      furthest =
          std::max(furthest, std::abs(limit.columns[c].response[k] - swept.columns[c].response[k]) / size);
    }
  CHECK(furthest > 1e-3);
}

TEST_CASE("the linear method with the time step of the run is refused where its motion is not known",
          "[spectrum]") {
  const std::string text = pressed_chain(
      "drive = 'lid.superposed'\nfrom_hz = 40\nto_hz = 120\nstep_hz = 20\nlinear.step = 'run'\n");
  const auto refusal = [](const std::string& of) {
    const scenario::Plan plan = driven_plan_of(of);
    return message([&] {
      linear_spectrum({plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()});
    });
  };
  CHECK(refusal(text).starts_with(
      "a motion that is superposed on a wall with mass has no linear response with "));
  CHECK(
      refusal(with(text, "[time]\n", "[time]\nintegrator = 'position_verlet'\n")) ==
      "the linear response with the time step of the run is that of velocity_verlet, not of position_verlet; leave it in the "
      "limit of short steps");
}
