#include "points.hpp"

#include "settings.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/state_hash.hpp>

namespace scree::campaign {

namespace {

// Number of choices of each factor of the product, slowest first: cases, parameters, seeds.
std::vector<std::size_t> factors_of(const Campaign& c) {
  std::vector<std::size_t> factors = {std::max<std::size_t>(1, c.cases.size())};
  for (const Parameter& parameter : c.parameters) factors.push_back(parameter.values.size());
  factors.push_back(std::max<std::size_t>(1, c.seeds.size()));
  return factors;
}

void add_all(std::vector<Setting>& settings, const std::vector<Setting>& more) {
  settings.insert(settings.end(), more.begin(), more.end());
}

Point make_point(const Campaign& c, const std::vector<std::size_t>& choices, const std::string& seeds_place) {
  Point point;
  point.settings = c.fixed;
  if (!c.cases.empty()) {
    point.case_name = c.cases[choices.front()].name;
    add_all(point.settings, c.cases[choices.front()].settings);
  }
  for (std::size_t k = 0; k < c.parameters.size(); ++k)
    point.settings.push_back(c.parameters[k].values[choices[k + 1]]);
  if (!c.seeds.empty()) {
    point.seed = c.seeds[choices.back()];
    point.settings.push_back({"scene.seed", std::to_string(*point.seed), seeds_place});
  }
  return point;
}

constexpr std::size_t max_name_length = 120;  // (bytes) below the 255 of file systems
// (bytes) A value that is longer, such as a list of probes, and has no alternative, says nothing in a name.
constexpr std::size_t longest_lone_value = 40;

// Converts a value to a readable part of a file name: "[5, 5, 8]" becomes "5_5_8", "1000.0" becomes "1000".
std::string file_safe(std::string_view text) {
  if (text.ends_with(".0")) text.remove_suffix(2);
  std::string safe;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (std::isalnum(code) || code >= 0x80 || c == '.' || c == '-' || c == '+' || c == '_')
      safe += c;
    else if (std::string_view(" \"'[]{}").find(c) == std::string_view::npos)
      safe += '_';
  }
  return safe;
}

// Last part of each key, or the whole key if another one has the same last part.
std::vector<std::string> labels_of(const std::vector<Parameter>& parameters) {
  std::vector<std::string> labels;
  std::map<std::string, int> count = {{"seed", 1}, {"case", 1}};
  for (const Parameter& parameter : parameters) {
    labels.push_back(file_safe(parameter.key.substr(parameter.key.rfind('.') + 1)));
    ++count[labels.back()];
  }
  for (std::size_t k = 0; k < labels.size(); ++k)
    if (count[labels[k]] > 1) labels[k] = file_safe(parameters[k].key);
  return labels;
}

std::string with_hash(std::string name, const std::string& exact) {
  StateHash hash;
  for (const char c : exact) hash.add(std::uint64_t(static_cast<unsigned char>(c)));
  std::size_t end = std::min(name.size(), max_name_length);
  while (end < name.size() && end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0u) == 0x80u) --end;
  return fmt::format("{}-{:016x}", name.substr(0, end), hash.value());
}

// Names the directory of each point, such as "case=soft,static_friction=0.1,seed=3". A name depends only on
// the settings of the point, unless another point would get the same name.
void name_points(const Campaign& campaign, std::vector<Point>& points) {
  const std::vector<std::string> labels = labels_of(campaign.parameters);
  std::vector<std::string> exact;
  std::map<std::string, int> count;
  for (Point& point : points) {
    std::vector<std::string> parts, exact_parts;
    const auto add = [&](const std::string& label, const std::string& value) {
      parts.push_back(label + "=" + file_safe(setting_text(value)));
      exact_parts.push_back(label + "=" + value);
    };
    if (!point.case_name.empty()) add("case", point.case_name);
    for (std::size_t k = 0; k < labels.size(); ++k) {
      const Parameter& parameter = campaign.parameters[k];
      const std::string& value = point.find(parameter.key)->value;
      if (parameter.values.size() > 1 || value.size() <= longest_lone_value) add(labels[k], value);
    }
    if (point.seed) add("seed", std::to_string(*point.seed));
    point.name = parts.empty() ? "run" : fmt::format("{}", fmt::join(parts, ","));
    exact.push_back(fmt::format("{}", fmt::join(exact_parts, ",")));
    ++count[point.name];
  }
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].name.size() > max_name_length || count[points[k].name] > 1)
      points[k].name = with_hash(points[k].name, exact[k]);
}

}  // namespace

std::size_t count_points(const Campaign& c, std::size_t max) {
  std::size_t count = 1;
  for (const std::size_t factor : factors_of(c)) {
    if (factor > max / count) return max + 1;
    count *= factor;
  }
  return count;
}

std::vector<Point> make_points(const Campaign& c, const std::string& seeds_place) {
  const std::vector<std::size_t> factors = factors_of(c);
  std::vector<Point> points;
  std::vector<std::size_t> choices(factors.size(), 0);
  for (bool more = true; more;) {
    points.push_back(make_point(c, choices, seeds_place));
    more = false;
    for (std::size_t k = factors.size(); k-- > 0 && !more;) {
      choices[k] = (choices[k] + 1) % factors[k];
      more = choices[k] > 0;
    }
  }
  name_points(c, points);
  return points;
}

}  // namespace scree::campaign
