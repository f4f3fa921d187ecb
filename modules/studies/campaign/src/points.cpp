#include "points.hpp"

#include "point_names.hpp"

#include <algorithm>

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
