#include "linear.hpp"

#include "bench.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>
#include <scree/spectrum/peak.hpp>

using namespace scree;
using namespace scree::spectrum;
using namespace scree::test;

TEST_CASE("the linear method gives the response of the discrete chain", "[spectrum]") {
  const Chain chain;
  const scenario::Plan plan =
      driven_plan_of(chain.text("from_hz = 20\nto_hz = 160\nstep_hz = 1\nlinear.fewest_contacts = 1\n"));
  const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
  const MethodSpectrum spectrum = linear_spectrum(start);
  REQUIRE(spectrum.frequencies.size() == 141);
  for (std::size_t k = 0; k < spectrum.frequencies.size(); ++k)
    for (const std::size_t c : {0u, 1u}) {
      CAPTURE(spectrum.frequencies[k], c);
      const std::complex<double> exact = chain.response(c == 0 ? 1 : Chain::beads, spectrum.frequencies[k]);
      // Round-off of a height of 0.08 m in a difference of up to 5e-6 m: 1.4e-17/5e-6 = 3e-12.
      CHECK(std::abs(spectrum.columns[c].response[k] - exact) < 1e-10 * std::abs(exact) + 1e-11);
    }
}

TEST_CASE("the linear method does not depend on the time step", "[spectrum]") {
  // Restitution makes dampers with the weight that makes up for predicted velocities: (ωh)²/2 of the damping.
  const auto spectrum_with = [](const std::string& step) {
    const scenario::Plan plan = driven_plan_of(
        with(with(Chain().text("from_hz = 20\nto_hz = 160\nstep_hz = 20\nlinear.fewest_contacts = 1\n"),
                  "normal_damping = 0.05", "restitution = 0.9"),
             fmt::format("step = {}\n", Chain::step), "step = " + step + "\n"));
    return linear_spectrum({plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()});
  };
  const MethodSpectrum coarse = spectrum_with("1e-4"), fine = spectrum_with("1e-6");
  for (std::size_t k = 0; k < fine.frequencies.size(); ++k)
    for (const std::size_t c : {0u, 1u}) {
      CAPTURE(fine.frequencies[k], c);
      const std::complex<double> h = fine.columns[c].response[k];
      CHECK(std::abs(coarse.columns[c].response[k] - h) <
            1e-10 * std::abs(h) + 1e-11);  // round-off, as above
    }
}

TEST_CASE("the linear method of a packing that is not at rest is that of the equilibrium nearby",
          "[spectrum]") {
  // Hertzian contacts, whose overlaps are off by 1 % of the total, one way or the other: their stiffness is
  // off by 0.5 %.
  const auto spectrum_with = [](double share) {
    std::string text = Chain{}.text("from_hz = 20\nto_hz = 160\nstep_hz = 20\nlinear.fewest_contacts = 1\n");
    text = with(text, "plugin = 'linear_spring_dashpot'\nnormal_stiffness = 1000\nnormal_damping = 0.05\n",
                "plugin = 'hertz_mindlin'\nyoungs_modulus = 2e6\npoissons_ratio = 0.25\nrestitution = 0.9\n");
    // f = (4/3) E* sqrt(R*) overlap^(3/2), E* = E/(2 (1 - nu^2)); R* is R at the wall and R/2 between beads.
    const double modulus = 2e6 / (2 * (1 - 0.0625));
    double top = 0;
    for (int i = 1; i <= Chain::beads; ++i) {
      const std::string before = fmt::format("id = {}\nposition = [0, 0, ", i);
      const std::size_t at = text.find(before) + before.size();
      const double force = (Chain::beads - i + 1) * Chain::mass * Chain::gravity;
      const double radius = i == 1 ? Chain::radius : 0.5 * Chain::radius;
      const double overlap = std::pow(0.75 * force / (modulus * std::sqrt(radius)), 2.0 / 3);
      top += (i == 1 ? 1 : 2) * Chain::radius - overlap * (1 + share);
      text.replace(at, text.find(']', at) - at, fmt::format("{:.17g}", top));
    }
    const scenario::Plan plan = driven_plan_of(text);
    return linear_spectrum({plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()});
  };
  const MethodSpectrum rest = spectrum_with(0), more = spectrum_with(0.01), less = spectrum_with(-0.01);
  CHECK(rest.notes.empty());
  REQUIRE(more.notes.size() == 1);
  CHECK_THAT(
      more.notes[0],
      Catch::StartsWith(
          "linear: the packing is not at rest: net forces, or torques over radii, on bodies and walls ") &&
          Catch::Contains("from the equilibrium nearby, whose linear response this is; "));
  for (std::size_t k = 0; k < rest.frequencies.size(); ++k) {
    CAPTURE(rest.frequencies[k]);
    const std::complex<double> h = rest.columns[1].response[k];
    // Balance to 1e-11 of the largest force; round-off of differences, as above.
    CHECK(std::abs(more.columns[1].response[k] - h) < 1e-8 * std::abs(h) + 1e-10);
    CHECK(std::abs(less.columns[1].response[k] - h) < 1e-8 * std::abs(h) + 1e-10);
  }
}

TEST_CASE("a linear method that was stopped goes on with the frequencies that it lacks", "[spectrum]") {
  const Chain chain;
  const scenario::Plan plan =
      driven_plan_of(chain.text("from_hz = 20\nto_hz = 160\nstep_hz = 1\nlinear.fewest_contacts = 1\n"));
  std::atomic<bool> stop = true;
  const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state(), &stop};
  MethodSpectrum spectrum;
  CHECK(!add_linear(start, spectrum));
  CHECK(spectrum.frequencies.empty());
  stop = false;
  const MethodSpectrum whole = linear_spectrum(start);
  // As if it had been stopped behind the frequencies in the middle.
  spectrum = whole;
  spectrum.frequencies.erase(spectrum.frequencies.begin() + 40, spectrum.frequencies.begin() + 99);
  for (MethodSpectrum::Column& column : spectrum.columns) {
    column.response.erase(column.response.begin() + 40, column.response.begin() + 99);
    column.error.erase(column.error.begin() + 40, column.error.begin() + 99);
    column.linearity.assign(column.response.size(), 0);
  }
  CHECK(add_linear(start, spectrum));
  CHECK(spectrum.frequencies == whole.frequencies);
  for (const std::size_t c : {0u, 1u}) {
    CHECK(spectrum.columns[c].response == whole.columns[c].response);
    CHECK(spectrum.columns[c].error == whole.columns[c].error);
    CHECK(spectrum.columns[c].linearity.empty());
  }
}

TEST_CASE("an adaptive linear method resolves maxima that are narrower than its grid", "[spectrum]") {
  const auto modes_with = [](const char* grid) {
    const scenario::Plan plan = driven_plan_of(
        Chain().text(fmt::format("from_hz = 20\nto_hz = 160\nlinear.fewest_contacts = 1\n{}\n", grid)));
    const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
    std::vector<signals::FittedMode> modes;
    for (const Peak& r : peaks_in({linear_spectrum(start)}, read_spectrum(plan)->observed))
      if (read_spectrum(plan)->observed[r.column].name == "particles.z_8") modes.push_back(r.mode);
    return modes;
  };
  const std::vector<signals::FittedMode> fine = modes_with("step_hz = 0.25");
  const std::vector<signals::FittedMode> refined = modes_with("step_hz = 7\nlinear.adaptive = true");
  CHECK(modes_with("step_hz = 7").size() < fine.size());
  REQUIRE(refined.size() == fine.size());
  // The same modes through fewer points; of what is no sum of modes, the fit leaves 1e-3 of a width.
  for (std::size_t k = 0; k < fine.size(); ++k)
    CHECK(std::abs(refined[k].frequency - fine[k].frequency) < 1e-2 * fine[k].width);
}

TEST_CASE("peaks of velocities are those of displacements", "[spectrum]") {
  const Chain chain = {.drag = 0.04};  // Q of the first mode: 4.5
  const scenario::Plan plan =
      driven_plan_of(with(chain.text("from_hz = 8\nto_hz = 60\nstep_hz = 0.5\nlinear.fewest_contacts = 1\n"),
                          "'particles.z_1'", "'particles.vz_8'"));
  const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
  const auto peaks = peaks_in({linear_spectrum(start)}, read_spectrum(plan)->observed);
  REQUIRE(peaks.size() == 2);
  const signals::FittedMode velocity = peaks[0].mode, displacement = peaks[1].mode;
  // Both fits take the flanks of the other modes for a line, with weights that differ by f.
  CHECK(velocity.frequency == Approx(displacement.frequency).epsilon(1e-4));
  CHECK(velocity.quality == Approx(displacement.quality).epsilon(5e-3));
  CHECK(velocity.amplitude ==
        Approx(2 * std::numbers::pi * displacement.frequency * displacement.amplitude).epsilon(1e-3));
}

TEST_CASE("a linear method at an undamped mode says at which frequency and what to do", "[spectrum]") {
  const Chain chain = {.damping = 0, .drag = 0};
  // Within round-off of the second mode.
  const scenario::Plan plan = driven_plan_of(chain.text(fmt::format(
      "from_hz = {:.17g}\nto_hz = 160\nstep_hz = 7\nlinear.fewest_contacts = 1\n", Chain::mode_hz(2))));
  const Start start{plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()};
  CHECK_THROWS_WITH(linear_spectrum(start), Catch::Contains("the response at 87.1096 Hz is infinite") &&
                                                Catch::Contains("; add damping"));
}

TEST_CASE("a column that does not respond is refused with those that do", "[spectrum]") {
  const auto refused = [](const char* observed) {
    std::string text = Chain().text("from_hz = 20\nto_hz = 60\nstep_hz = 20\nlinear.fewest_contacts = 1\n");
    text = with(text, "observe = ['particles.z_1', 'particles.z_8']",
                fmt::format("observe = ['particles.z_1', '{}']", observed));
    const scenario::Plan plan = driven_plan_of(text + "[[probe]]\nplugin = 'energy'\nevery = 1\n");
    return message([&] {
      linear_spectrum({plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()});
    });
  };
  // A chain along z; spins do not follow, as no contact turns bodies.
  for (const char* column : {"particles.x_8", "particles.spin_x_8"})
    CHECK_THAT(refused(column),
               Catch::Contains(fmt::format("'{}' does not respond", column)) &&
                   Catch::EndsWith("; observe one that does: particles.z_1, particles.vz_1, particles.z_8, "
                                   "particles.vz_8, or leave the method linear out"));
  CHECK_THAT(refused("energy.kinetic_translation"),
             Catch::Contains("'energy.kinetic_translation' is of a probe that reads contacts or energies"));
}

TEST_CASE("a law from outside without derivatives is named with what to do", "[spectrum]") {
  PluginHost both({SCREE_TEST_PLUGINS, SCREE_TEST_OUTSIDE});
  const TemporaryFolder folder;
  const std::string text =
      with(Chain().text("from_hz = 20\nto_hz = 160\nstep_hz = 1\nlinear.fewest_contacts = 1\n"),
           "plugin = 'linear_spring_dashpot'\nnormal_stiffness = 1000\nnormal_damping = 0.05\n",
           "plugin = 'hand_written'\nstiffness = 1000\n");
  const scenario::Plan plan = scenario::read_plan(folder.write("s.toml", text), {"time.step_guard=false"},
                                                  both, {spectrum::spectrum_table()});
  CHECK(
      message([&] {
        linear_spectrum({plan, *read_spectrum(plan), plan.scene, run::set_up(plan)->state()});
      }) ==
      "contact law 'hand_written' has no derivatives, from which a linear response follows; measure with a pulse or a "
      "sweep, or build the law with SCREE_CONTACT_LAW_PLUGIN");
}

TEST_CASE("a linear method that is interrupted keeps what it has and goes on to the same table",
          "[spectrum]") {
  // Beads on a cubic lattice, whose 384 motions are solved as in large packings.
  std::string text =
      "[time]\nstep = 5e-5\n[[material]]\nname = 'sphere'\ndensity = 2000\n"
      "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1000\nnormal_damping = 0.05\n"
      "[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\ndisplacement = 0\n"
      "[[probe]]\nplugin = 'particles'\nids = [128]\n"
      "[spectrum]\ndrive = 'floor.displacement'\namplitude = 1e-8\nobserve = ['particles.z_128']\n"
      "from_hz = 20\nto_hz = 160\nstep_hz = 2\nlinear.fewest_contacts = 1\n";
  for (int n = 0; n < 128; ++n)
    text += fmt::format("[[particle]]\nid = {}\nradius = 0.005\nposition = [{}, {}, {}]\n", n + 1,
                        0.00995 * (n % 4), 0.00995 * (n / 4 % 4), 0.00495 + 0.00995 * (n / 16));
  Bench whole(text), parted(text);
  whole.options.methods = parted.options.methods = {Method::linear};
  CHECK(measure(whole.plan, whole.options).spectra.at(0).frequencies.size() == 71);

  std::atomic<bool> stop = false;
  parted.options.stop = &stop;
  std::vector<double> shares;
  parted.options.on_progress = [&](double share, double, const std::string& what) {
    CHECK(what == "linear response");
    shares.push_back(share);
    stop = share > 0.4;
  };
  const Measurement first = measure(parted.plan, parted.options);
  REQUIRE(first.interrupted);
  CHECK(first.spectra.at(0).frequencies.size() == 24);  // one window; the second was stopped
  const std::string part = parted.text("spectrum.csv");
  CHECK(std::count(part.begin(), part.end(), '\n') == 25);
  stop = false;
  shares.clear();
  parted.options.on_progress = [&](double share, double, const std::string&) { shares.push_back(share); };
  CHECK(!resume_measurement(parted.options, host()).interrupted);
  CHECK(shares.front() == Approx(24.0 / 71));
  CHECK(shares.back() == 1);
  CHECK(parted.text("spectrum.csv") == whole.text("spectrum.csv"));
}
