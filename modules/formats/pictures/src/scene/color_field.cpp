#include "color_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/charts/scaled_unit.hpp>
#include <scree/charts/ticks.hpp>
#include <scree/error.hpp>
#include <scree/pictures/view_range.hpp>

namespace scree::pictures {
namespace {

using charts::AxisSpan;

// Discs must not hide the bars of contacts on them.
constexpr double paleness_among_contacts = 0.6;

struct RawField {
  const char* title;
  const char* unit;
  std::vector<double> values;
  bool whole_numbers = false;
};

RawField raw_field(const Frame& frame, const std::string& name) {
  struct Known {
    std::string_view name;
    const char *title, *unit;
    bool whole_numbers;
  };
  static constexpr Known all[] = {{"radius", "radius", "m", false},
                                  {"speed", "speed", "m/s", false},
                                  {"velocity_x", "velocity x", "m/s", false},
                                  {"velocity_y", "velocity y", "m/s", false},
                                  {"velocity_z", "velocity z", "m/s", false},
                                  {"material", "material", "", true},
                                  {"spin", "spin", "rad/s", false},
                                  {"coordination", "contacts", "", true},
                                  {"pressure", "pressure", "Pa", false},
                                  {"largest_force", "largest force", "N", false},
                                  {"net_force", "net force", "N", false},
                                  {"id", "id", "", true},
                                  {"displacement", "displacement", "m", false},
                                  {"displacement_x", "displacement x", "m", false},
                                  {"displacement_y", "displacement y", "m", false},
                                  {"displacement_z", "displacement z", "m", false},
                                  {"group", "group", "", true}};
  for (const Known& known : all)
    if (known.name == name) return {known.title, known.unit, color_values(frame, name), known.whole_numbers};
  throw Error(
      fmt::format("color_by: unknown field \"{}\"; choose one of {}", name, fmt::join(color_fields, ", ")));
}

AxisSpan value_range(const RawField& field) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  AxisSpan range{infinity, -infinity};
  for (double value : field.values)
    if (std::isfinite(value)) range = {std::min(range.lower, value), std::max(range.upper, value)};
  if (range.lower > range.upper) return {0, 1};
  const double size = std::max(std::abs(range.lower), std::abs(range.upper));
  if (range.upper - range.lower > 1e-12 * size) return range;
  if (range.lower == 0) return {0, 1};
  return field.whole_numbers ? AxisSpan{range.lower - 1, range.upper + 1}
                             : charts::padded(range.lower, range.upper, 0);
}

// The values, if there are up to five of them.
std::vector<double> few_values(const std::vector<double>& values) {
  constexpr std::size_t most = 5;
  std::vector<double> distinct;
  for (const double value : values) {
    if (std::find(distinct.begin(), distinct.end(), value) != distinct.end()) continue;
    distinct.push_back(value);
    if (distinct.size() > most || !std::isfinite(value)) return {};
  }
  std::sort(distinct.begin(), distinct.end());
  return distinct;
}

std::array<std::uint8_t, 3> paled(std::array<std::uint8_t, 3> color, double paleness) {
  for (std::uint8_t& part : color) part = std::uint8_t(std::lround(std::lerp(part, 255, paleness)));
  return color;
}

Error absent_field(const std::string& name) {
  if (name == "group" || name.starts_with("displacement"))
    return Error(
        fmt::format("color_by: these snapshots have no {0}; run the scene with color_by = \"{0}\" in "
                    "[snapshot], or choose another",
                    name));
  return Error(fmt::format("color_by: this scene has no {}; choose another of {}", name,
                           fmt::join(color_fields, ", ")));
}

// Bodies in no group are grey.
ColorField group_field(const Frame& frame, std::vector<double> values, double paleness) {
  const double groups = double(frame.groups.size());
  for (const double value : values)
    if (!(value >= -1 && value < groups))
      throw Error("frame: a body has a group that has no name; draw a frame that a run has written");
  return {.title = "group",
          .values = std::move(values),
          .lower = 0,
          .upper = 1,
          .whole_numbers = true,
          .paleness = paleness,
          .names = frame.groups};
}

AxisSpan given_range(const std::array<double, 2>& range) {
  if (std::isfinite(range[0]) && std::isfinite(range[1]) && range[0] < range[1]) return {range[0], range[1]};
  throw Error(fmt::format("color_range: [{}, {}] is not a range; give a lower and a greater upper value",
                          range[0], range[1]));
}

}  // namespace

std::array<std::uint8_t, 3> viridis(double t) {
  static constexpr int knots = 9;
  static constexpr double map[knots][3] = {{68, 1, 84},    {71, 44, 122},  {59, 81, 139},
                                           {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                                           {92, 200, 99},  {170, 220, 50}, {253, 231, 37}};
  if (std::isnan(t)) return {160, 160, 160};
  const double place = std::clamp(t, 0.0, 1.0) * (knots - 1);
  const int knot = std::min(int(place), knots - 2);
  std::array<std::uint8_t, 3> color;
  for (int k = 0; k < 3; ++k)
    color[k] = std::uint8_t(std::lround(std::lerp(map[knot][k], map[knot + 1][k], place - knot)));
  return color;
}

std::array<std::uint8_t, 3> ColorField::color_at(double share) const {
  return paled(viridis(share), paleness);
}

std::array<std::uint8_t, 3> ColorField::color_of(double value) const {
  if (names.empty()) return color_at((value - lower) / (upper - lower));
  return paled(value < 0 ? viridis(NAN) : group_colors[std::size_t(value) % group_colors.size()], paleness);
}

std::vector<ColorField::Entry> ColorField::legend() const {
  std::vector<Entry> entries;
  for (const double value : distinct) entries.push_back({color_of(value), fmt::format("{:.4g}", value)});
  for (std::size_t k = 0; k < names.size(); ++k) entries.push_back({color_of(double(k)), names[k]});
  if (!names.empty() && std::count(values.begin(), values.end(), -1) > 0)
    entries.push_back({color_of(-1), "in no group"});
  return entries;
}

ColorField color_field(const Frame& frame, const RenderOptions& options) {
  RawField raw = raw_field(frame, options.color_by);
  if (raw.values.size() != frame.particle_count()) throw absent_field(options.color_by);
  const double paleness = options.show_contacts && frame.dimension == 2 ? paleness_among_contacts : 0;
  if (options.color_by == "group") return group_field(frame, std::move(raw.values), paleness);
  const AxisSpan range = options.color_range ? given_range(*options.color_range) : value_range(raw);
  const charts::ScaledUnit unit =
      charts::scaled_unit(std::max(std::abs(range.lower), std::abs(range.upper)), raw.unit);
  for (double& value : raw.values) value *= unit.factor;
  const std::string title = unit.symbol.empty() ? raw.title : fmt::format("{} ({})", raw.title, unit.symbol);
  const bool materials = options.color_by == "material";
  std::vector<double> distinct =
      materials || options.color_by == "radius" ? few_values(raw.values) : std::vector<double>();
  if (distinct.size() == 1 && !materials) distinct.clear();  // a bar has the range around a single radius
  return {title,
          std::move(raw.values),
          range.lower * unit.factor,
          range.upper * unit.factor,
          raw.whole_numbers,
          paleness,
          std::move(distinct)};
}

}  // namespace scree::pictures
