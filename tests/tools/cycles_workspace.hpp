#pragma once

#include "program.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

// A run of cycles without a simulation.

namespace scree::test {

// A series of a probe `box`: a load of period 2 s from 1.5 s on, 8 samples in each of 60 cycles, and lengths
// that ratchet by 1e-6 per cycle.
inline std::string series_of_cycles() {
  std::string text = "time [s],length_x [m],length_y [m],strain,stress [Pa],none\n";
  for (int k = 0; k <= 480; ++k) {
    const double t = 0.25 * k, turn = std::numbers::pi * t;
    const double strain = 1e-3 * std::sin(turn) + 1e-6 * t / 2;
    text += fmt::format("{},{},{},{},{},7\n", 1.5 + t, 2.0, 3 * (1 + strain), strain, 5 - std::cos(turn));
  }
  return text;
}

// The directory of a run whose second stage has the period.
inline void write_run(const Workspace& w, const std::string& name) {
  std::filesystem::create_directories(w / (name + "/series"));
  w.write(name + "/series/box.csv", series_of_cycles());
  w.write(name + "/series/energy.csv", "time [s],kinetic [J]\n0,1\n1,1\n");
  w.write(name + "/scenario.toml", "[[stage]]\nduration = 1.5\n[[stage]]\ncycles = 60\nperiod = 2\n");
  w.write(name + "/run.json", R"({"stages": [{"start": 0, "end": 1.5}, {"start": 1.5, "end": 121.5}]})");
}

}  // namespace scree::test
