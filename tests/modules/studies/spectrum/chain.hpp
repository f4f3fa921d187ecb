#pragma once

#include "plan_support.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::test {

// A plan whose scenario has [spectrum].
inline scenario::Plan driven_plan_of(const std::string& text,
                                     const std::vector<std::string>& overrides = {}) {
  return plan_of(text, overrides, {spectrum::spectrum_table()});
}

// A column of beads on a plane that moves up and down; gravity keeps linear contacts closed.
struct Chain {
  static constexpr int beads = 8;
  static constexpr double stiffness = 1000, mass = 1e-3, radius = 0.005, gravity = 10, step = 5e-5;
  double damping = 0.05;  // (kg/s) of a contact
  double drag = 0.01;     // (kg/s) on each bead

  // Scene with the keys of [spectrum] after those of every test.
  std::string text(const std::string& spectrum) const {
    std::string text = fmt::format(
        "[time]\nstep = {}\n[[material]]\nname = 'sphere'\ndensity = 2000\n"
        "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = {}\nnormal_damping = {}\n"
        "[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\ndisplacement = 0\n"
        "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, 0, {}]\n"
        "[[body_force]]\nplugin = 'background_damping'\ntranslational = {}\n"
        "[[probe]]\nplugin = 'particles'\nevery = 1e-3\nids = [1, {}]\n",
        step, stiffness, damping, -gravity, drag, beads);
    double top = 0;
    for (int i = 1; i <= beads; ++i) {
      top += (i == 1 ? radius : 2 * radius) - (beads - i + 1) * mass * gravity / stiffness;
      text += fmt::format("[[particle]]\nid = {}\nposition = [0, 0, {}]\nradius = {}\nmass = {}\n", i, top,
                          radius, mass);
    }
    return text +
           "[spectrum]\ndrive = 'floor.displacement'\namplitude = 1e-8\nobserve = ['particles.z_1', 'particles.z_8']\n" +
           spectrum;
  }

  // A probe "profile" with a layer per bead.
  static constexpr const char* layers =
      "[[probe]]\nplugin = 'profile'\naxis = 'z'\nbins = 8\nlow = 0\nhigh = 0.0796\n";

  // ω_j/2π (Hz) without damping, for j from 1.
  static double mode_hz(int j) {
    return std::sqrt(stiffness / mass) * std::sin((2 * j - 1) * std::numbers::pi / (2 * (2 * beads + 1))) /
           std::numbers::pi;
  }
  // The frequency at which velocity Verlet oscillates instead: sin(ω'h/2) = ωh/2.
  static double with_step(double hz) {
    return std::asin(std::numbers::pi * hz * step) / (std::numbers::pi * step);
  }
  // u_n over the displacement of the floor, in continuous time.
  std::complex<double> response(int n, double hz) const {
    const double omega = 2 * std::numbers::pi * hz;
    const std::complex<double> inertia(mass * omega * omega, -omega * drag),
        spring(stiffness, omega * damping);
    const std::complex<double> kappa = 2.0 * std::asin(0.5 * std::sqrt(inertia / spring));
    return std::cos(kappa * (beads + 0.5 - n)) / std::cos(kappa * (beads + 0.5));
  }
};

}  // namespace scree::test
