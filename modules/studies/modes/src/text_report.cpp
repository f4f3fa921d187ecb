#include "vibration_files.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>

namespace scree::modes {

namespace {

constexpr std::size_t most_modes = 30, most_names = 8;

std::string names_of(const Vibration& v, const std::vector<Participant>& bodies) {
  std::string text;
  for (std::size_t k = 0; k < std::min(bodies.size(), most_names); ++k)
    text += fmt::format("{}{}", k > 0 ? ", " : "", v.names[bodies[k].body]);
  return bodies.size() > most_names ? text + ", ..." : text;
}

std::string head(const Vibration& v) {
  std::string text = fmt::format("{} with {}, {}; {} left out; asymmetry of K {:.2g}\n",
                                 counted(v.bodies, "body", "bodies"), counted(v.contacts, "contact"),
                                 counted(v.degrees_of_freedom, "degree of freedom", "degrees of freedom"),
                                 counted(v.rattlers.size(), "rattler is", "rattlers are"), v.asymmetry);
  text += v.counted
              ? fmt::format("{}, {}", counted(v.unstable, "unstable mode"), counted(v.floppy, "floppy mode"))
              : "unstable and floppy modes were not counted";
  if (!v.floppy_bodies.empty())
    text += fmt::format(" of {}: {} (floppy.csv)", counted(v.floppy_bodies.size(), "body", "bodies"),
                        names_of(v, v.floppy_bodies));
  return text + "\n";
}

std::string mode_lines(const Vibration& v) {
  std::string text = fmt::format("{:>5} {:>14} {:>10} {:>13} {:>9} {:>6} {:>6} {:>6} {:>6} {:>18}\n", "mode",
                                 "frequency [Hz]", "residual", "participation", "rotation", "x", "y", "z",
                                 "walls", "energy decay [1/s]");
  std::size_t lines = 0, all = 0;
  for (const Mode& m : v.modes) {
    if (m.kind != ModeKind::vibrating) continue;
    ++all;
    if (lines == most_modes) continue;
    ++lines;
    text += fmt::format(
        "{:>5} {:>14.8g} {:>10.2g} {:>13.3f} {:>9.3f} {:>6.3f} {:>6.3f} {:>6.3f} {:>6.3f} {:>18.4g}\n",
        m.number, m.frequency_hz, m.residual, m.participation, m.rotation, m.direction[0], m.direction[1],
        m.direction[2], m.walls + m.turns, m.damping_rate);
  }
  if (all == 0) return "";
  if (all > lines) text += fmt::format("... {} more in modes.csv\n", all - lines);
  return text;
}

std::string elastic_lines(const response::ElasticModuli& e) {
  const std::string unit = unit_of_moduli(e);
  const auto line = [&](const std::string& what, const std::string& of, double whole, double in_middle) {
    return fmt::format("{:<38} {:>14.6g} {:>14.6g}  {}\n", what, whole, in_middle, of);
  };
  std::string text = fmt::format("{:<38} {:>14} {:>14}\n", "elastic constants, both walls held",
                                 "between walls", "middle half");
  text += line(fmt::format("oedometric modulus M along {}", "xyz"[e.compression.axis]), unit,
               e.compression.modulus, e.compression.middle_modulus);
  response::ElasticModuli middle = e;
  middle.compression.modulus = e.compression.middle_modulus;
  for (std::size_t k = 0; k < e.shear.size(); ++k) {
    middle.shear[k].modulus = e.shear[k].middle_modulus;
    text += line(fmt::format("shear modulus G along {}", "xyz"[e.shear[k].axis]), unit, e.shear[k].modulus,
                 e.shear[k].middle_modulus);
  }
  text += line("Young's modulus E, if isotropic", unit, e.youngs_modulus(), middle.youngs_modulus());
  text += line("Poisson's ratio, if isotropic", "", e.poissons_ratio(), middle.poissons_ratio());
  text += fmt::format("{:<38} {:>14.6g}\n", "lateral over normal stress K0", e.lateral_ratio());
  text += fmt::format("{:<38} {:>14.6g}\n", "Poisson's ratio by K0", e.poissons_ratio_by_lateral_ratio());
  return text;
}

// Displacements of walls, by the loads on them.
std::string load_lines(const Vibration& v) {
  std::string text = "load of 1 N on     moves (m)\n";
  for (const response::LoadResponse& load : v.loads) {
    text += fmt::format("{:<18}", v.walls[load.wall]);
    for (const response::LoadResponse& other : v.loads)
      text += fmt::format(" {} {:.6g}", v.walls[other.wall], load.walls[other.wall]);
    text += "\n";
  }
  return text + "straight paths of bodies and contact forces: load_bodies.csv, load_contacts.csv\n";
}

}  // namespace

std::string text_report(const Vibration& v) {
  std::string text = head(v) + mode_lines(v);
  if (v.elastic) text += elastic_lines(*v.elastic);
  if (!v.loads.empty()) text += load_lines(v);
  if (!v.density.empty())
    text += fmt::format("{} up to {:.6g} Hz counted at {}: density.csv\n",
                        counted(v.density.back().below, "mode"), v.density.back().to_hz,
                        counted(v.density.size(), "frequency", "frequencies"));
  return text;
}

}  // namespace scree::modes
