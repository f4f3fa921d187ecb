#include "color_field.hpp"

#include "ticks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/error.hpp>

namespace scree::snapshot {
namespace {

struct RawField {
  const char* title;
  const char* unit;
  std::vector<double> values;
  bool whole_numbers = false;
};

std::vector<double> magnitudes(const std::vector<double>& vectors) {
  std::vector<double> values(vectors.size() / 3);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = std::hypot(vectors[3 * k], vectors[3 * k + 1], vectors[3 * k + 2]);
  return values;
}

RawField raw_field(const Frame& frame, const std::string& name) {
  if (name == "radius") return {"radius", "m", frame.radius};
  if (name == "speed") return {"speed", "m/s", magnitudes(frame.velocity)};
  if (name == "spin") return {"spin", "rad/s", magnitudes(frame.spin)};
  if (name == "force") return {"net force", "N", magnitudes(frame.force)};
  if (name == "coordination")
    return {"contacts", "", {frame.coordination.begin(), frame.coordination.end()}, true};
  if (name == "id") return {"id", "", {frame.id.begin(), frame.id.end()}, true};
  throw Error(
      fmt::format("color_by: unknown field \"{}\"; choose one of {}", name, fmt::join(color_fields, ", ")));
}

Range value_range(const RawField& field) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range range{infinity, -infinity};
  for (double value : field.values)
    if (std::isfinite(value)) range = {std::min(range.lower, value), std::max(range.upper, value)};
  if (range.lower > range.upper) return {0, 1};
  if (range.lower < range.upper) return range;
  return field.whole_numbers ? Range{range.lower - 1, range.upper + 1} : padded(range.lower, range.upper, 0);
}

Range given_range(const std::array<double, 2>& range) {
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

ScaledUnit scaled_unit(double largest, const std::string& unit) {
  struct Prefix {
    double factor;
    const char* symbol;
  };
  static constexpr Prefix prefixes[] = {{1e-6, "M"}, {1e-3, "k"}, {1, ""},
                                        {1e3, "m"},  {1e6, "µ"},  {1e9, "n"}};
  if (unit.empty() || largest == 0 || (largest >= 0.1 && largest < 1000)) return {1, unit};
  for (const Prefix& prefix : prefixes)
    if (largest * prefix.factor >= 1) return {prefix.factor, prefix.symbol + unit};
  return {1, unit};
}

ColorField color_field(const Frame& frame, const RenderOptions& options) {
  RawField raw = raw_field(frame, options.color_by);
  if (raw.values.size() != frame.particle_count())
    throw Error(fmt::format("color_by: this scene has no {}; choose another of {}", options.color_by,
                            fmt::join(color_fields, ", ")));
  const Range range = options.color_range ? given_range(*options.color_range) : value_range(raw);
  const ScaledUnit unit = scaled_unit(std::max(std::abs(range.lower), std::abs(range.upper)), raw.unit);
  for (double& value : raw.values) value *= unit.factor;
  const std::string title = unit.symbol.empty() ? raw.title : fmt::format("{} ({})", raw.title, unit.symbol);
  return {title, std::move(raw.values), range.lower * unit.factor, range.upper * unit.factor,
          raw.whole_numbers};
}

}  // namespace scree::snapshot
