#include "vibration_files.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <scree/charts/draw_chart.hpp>
#include <scree/files/csv_line.hpp>

namespace scree::modes {

namespace {

using files::csv_line;
using files::csv_number;
using Json = nlohmann::ordered_json;

constexpr const char* axes[] = {"x", "y", "z"};

std::string participants_text(const Vibration& v, const Mode& mode) {
  std::string text;
  for (const Participant& p : mode.participants)
    text += fmt::format("{}{}", text.empty() ? "" : " ", v.names[p.body]);
  return text;
}

std::string mode_table(const Vibration& v) {
  std::string text =
      csv_line({"kind", "number", "frequency [Hz]", "square_frequency [1/s^2]", "residual", "participation",
                "rotation", "x", "y", "z", "walls", "wall_turns", "damping_rate [1/s]", "bodies"});
  for (const Mode& m : v.modes)
    text += csv_line({mode_kind_names[std::size_t(m.kind)], fmt::format("{}", m.number),
                      csv_number(m.frequency_hz), csv_number(m.square_frequency), csv_number(m.residual),
                      csv_number(m.participation), csv_number(m.rotation), csv_number(m.direction[0]),
                      csv_number(m.direction[1]), csv_number(m.direction[2]), csv_number(m.walls),
                      csv_number(m.turns), csv_number(m.damping_rate), participants_text(v, m)});
  return text;
}

std::string floppy_table(const Vibration& v) {
  std::string text = csv_line({"body", "modes"});
  for (const Participant& p : v.floppy_bodies)
    text += csv_line({fmt::format("{}", v.names[p.body]), csv_number(p.share)});
  return text;
}

std::string density_table(const Vibration& v, int dimension) {
  std::string text = csv_line({"from [Hz]", "to [Hz]", "modes", "modes_below", "density [1/Hz]",
                               dimension == 2 ? "reduced [1/Hz^2]" : "reduced [1/Hz^3]"});
  for (const DensityPoint& p : v.density)
    text += csv_line({csv_number(p.from_hz), csv_number(p.to_hz), fmt::format("{}", p.modes),
                      fmt::format("{}", p.below), csv_number(p.density), csv_number(p.reduced)});
  return text;
}

std::string elastic_table(const response::ElasticModuli& e) {
  const std::string unit = unit_of_moduli(e);
  std::vector<std::string> head = {"wall_along", fmt::format("modulus [{}]", unit),
                                   fmt::format("middle_modulus [{}]", unit)};
  for (std::size_t k = 0; k < e.compression.virial.size(); ++k)
    head.push_back(fmt::format("stress_{}{} [{}]", axes[k], axes[k], unit));
  head.insert(head.end(), {"balance", "residual"});
  std::string text = csv_line(head);
  std::vector<response::StrainResponse> all = {e.compression};
  all.insert(all.end(), e.shear.begin(), e.shear.end());
  for (const response::StrainResponse& s : all) {
    std::vector<std::string> cells = {axes[s.axis], csv_number(s.modulus), csv_number(s.middle_modulus)};
    for (const double stress : s.virial) cells.push_back(csv_number(stress));
    cells.push_back(csv_number(s.balance)), cells.push_back(csv_number(s.residual));
    text += csv_line(cells);
  }
  return text;
}

std::string name_of(const Vibration& v, std::uint32_t end) {
  return end < v.names.size() ? fmt::format("{}", v.names[end]) : v.walls[end - v.names.size()];
}

std::string load_table(const Vibration& v) {
  std::string text = csv_line({"load_on", "wall", "displacement [m/N]"});
  for (const response::LoadResponse& load : v.loads)
    for (std::size_t w = 0; w < load.walls.size(); ++w)
      text += csv_line({v.walls[load.wall], v.walls[w], csv_number(load.walls[w])});
  return text;
}

std::string load_table_of_bodies(const Vibration& v) {
  std::vector<std::string> head = {"load_on", "body"};
  for (int k = 0; k < v.dimension; ++k) head.push_back(fmt::format("{} [m/N]", axes[k]));
  const std::size_t columns = v.loads.front().displacement.size() / v.loads.front().bodies.size();
  const int spins = int(columns) - v.dimension;
  for (int k = 0; k < spins; ++k)
    head.push_back(fmt::format("rotation_{} [rad/N]", axes[spins == 1 ? 2 : k]));
  std::string text = csv_line(head);
  for (const response::LoadResponse& load : v.loads)
    for (std::size_t i = 0; i < load.bodies.size(); ++i) {
      std::vector<std::string> cells = {v.walls[load.wall], name_of(v, load.bodies[i])};
      for (std::size_t k = 0; k < columns; ++k)
        cells.push_back(csv_number(load.displacement[i * columns + k]));
      text += csv_line(cells);
    }
  return text;
}

std::string load_table_of_contacts(const Vibration& v) {
  std::string text = csv_line({"load_on", "a", "b", "sliding", "normal_force [N]", "tangential_force [N]",
                               "normal_change [N/N]", "tangential_change [N/N]"});
  for (const response::LoadResponse& load : v.loads)
    for (const response::LoadedContact& c : load.contacts)
      text += csv_line({v.walls[load.wall], name_of(v, c.a), name_of(v, c.b), c.sliding ? "1" : "0",
                        csv_number(c.normal_force), csv_number(c.tangential_force),
                        csv_number(c.normal_change), csv_number(c.tangential_change)});
  return text;
}

Json json_of(const response::ElasticModuli& e) {
  Json json = {{"distance", e.walls.distance},
               {"area", e.walls.area},
               {"unit", unit_of_moduli(e)},
               {"oedometric_modulus", e.compression.modulus},
               {"oedometric_modulus_middle", e.compression.middle_modulus}};
  for (const response::StrainResponse& s : e.shear) {
    json[fmt::format("shear_modulus_{}", axes[s.axis])] = s.modulus;
    json[fmt::format("shear_modulus_middle_{}", axes[s.axis])] = s.middle_modulus;
  }
  json["shear_modulus"] = e.shear_modulus();
  json["youngs_modulus"] = e.youngs_modulus();
  json["poissons_ratio"] = e.poissons_ratio();
  json["lateral_ratio"] = e.lateral_ratio();
  json["poissons_ratio_by_lateral_ratio"] = e.poissons_ratio_by_lateral_ratio();
  return json;
}

Json json_of_modes(const Vibration& v) {
  Json modes = Json::object();
  for (const Mode& m : v.modes)
    if (m.kind == ModeKind::vibrating)
      modes[fmt::format("mode_{}", m.number)] = {{"frequency", m.frequency_hz},
                                                 {"residual", m.residual},
                                                 {"participation", m.participation},
                                                 {"rotation", m.rotation},
                                                 {"damping_rate", m.damping_rate}};
  return modes;
}

void draw(const Vibration& v, const run::RunDirectory& directory, const char* file, const std::string& label,
          double DensityPoint::*value) {
  const bool in_khz = v.density.back().to_hz >= 1e4;
  charts::ChartSpec chart;
  chart.title = v.title;
  chart.x_label = in_khz ? "frequency (kHz)" : "frequency (Hz)";
  chart.y_label = label;
  charts::ChartSeries curve;
  // Steps: the density between two frequencies is a mean.
  for (const DensityPoint& p : v.density)
    for (const double f : {p.from_hz, p.to_hz}) {
      curve.x.push_back(in_khz ? 1e-3 * f : f);
      curve.y.push_back(p.*value);
    }
  chart.series.push_back(std::move(curve));
  charts::draw_chart(chart, directory.add(file));
}

}  // namespace

const char* unit_of_moduli(const response::ElasticModuli& moduli) {
  return moduli.shear.size() == 1 ? "N/m" : "Pa";
}

Json record_of(const Vibration& v) {
  Json json = {{"title", v.title}, {"bodies", v.bodies}, {"rattlers", v.rattlers}};
  json["contacts"] = v.contacts;
  json["degrees_of_freedom"] = v.degrees_of_freedom;
  json["asymmetry"] = v.asymmetry;
  json["unstable_modes"] = v.counted ? Json(v.unstable) : Json();
  json["floppy_modes"] = v.counted ? Json(v.floppy) : Json();
  json["complete"] = v.complete;
  json["modes"] = json_of_modes(v);
  if (v.elastic) json["elastic"] = json_of(*v.elastic);
  for (const auto& [what, wall] : v.seconds) json["wall_s"][what] = wall;
  json["pictures"] = v.pictures;
  json["expect"] = Json::array();
  return json;
}

Json json_of(const VibrationOptions& options) {
  Json json = {{"modes", options.modes}, {"residual", options.residual_limit}};
  if (options.near_hz > 0) json["near"] = options.near_hz;
  if (options.elastic) json["elastic"] = true;
  if (options.loads) json["loads"] = true;
  if (options.density > 0) json["density"] = options.density;
  if (options.density_to_hz > 0) json["density_to"] = options.density_to_hz;
  if (options.fewest_contacts > 0) json["fewest_contacts"] = options.fewest_contacts;
  if (options.contacts_slide) json["sliding"] = true;
  if (!options.pictures.empty()) json["picture"] = fmt::format("{}", fmt::join(options.pictures, ","));
  if (!options.view.empty()) json["view"] = options.view;
  return json;
}

void write_tables(const Vibration& v, const run::RunDirectory& directory) {
  if (!v.modes.empty()) directory.write_file("modes.csv", mode_table(v));
  if (!v.floppy_bodies.empty()) directory.write_file("floppy.csv", floppy_table(v));
  if (v.elastic) directory.write_file("elastic.csv", elastic_table(*v.elastic));
  if (!v.loads.empty()) {
    directory.write_file("loads.csv", load_table(v));
    directory.write_file("load_bodies.csv", load_table_of_bodies(v));
    directory.write_file("load_contacts.csv", load_table_of_contacts(v));
  }
  if (!v.density.empty()) directory.write_file("density.csv", density_table(v, v.dimension));
}

void draw_charts(const Vibration& v, const run::RunDirectory& directory) {
  if (v.density.empty()) return;
  draw(v, directory, "charts/density.png", "modes per Hz and body (1/Hz)", &DensityPoint::density);
  draw(v, directory, "charts/density_reduced.png",
       v.dimension == 2 ? "modes per Hz and body over frequency (1/Hz^2)"
                        : "modes per Hz and body over frequency squared (1/Hz^3)",
       &DensityPoint::reduced);
}

}  // namespace scree::modes
