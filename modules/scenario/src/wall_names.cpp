#include "readers.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <scree/scene_checks.hpp>

namespace scree::scenario {

namespace {

bool is_text(const std::string& element) { return element.starts_with('"') || element.starts_with('\''); }

double number_of(const std::string& element) {
  double number = 0;
  std::from_chars(element.data(), element.data() + element.size(), number);
  return number;
}

}  // namespace

// What is neither a name nor a number becomes 0, which is out of the range of such lists.
std::vector<double> read_numbers_or_walls(const document::Table& table, const char* key, const Scene& scene) {
  const bool planes = std::string_view(key).ends_with("walls"),
             surfaces = std::string_view(key).ends_with("surfaces");
  if (!(planes || surfaces) || !table.is_array(key)) return table.numbers(key);
  const std::vector<std::string> elements = table.toml_elements(key);
  if (std::none_of(elements.begin(), elements.end(), is_text)) return table.numbers(key);
  const std::vector<std::string> names = planes ? plane_names(scene) : surface_names(scene);
  std::vector<double> numbers;
  // at_walls, at_surfaces: the id of a body before each wall.
  const bool pairs = std::string_view(key).starts_with("at_");
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const std::string& element = elements[k];
    if (pairs && k % 2 == 0 && is_text(element))
      throw table.error(key, k, element + " is a name in the place of an id",
                        "give the id of the body, then the number or the name of the wall");
    if (!is_text(element))
      numbers.push_back(number_of(element));
    else
      numbers.push_back(1.0 + double(find_name(table, key, planes ? "plane" : "surface",
                                               element.substr(1, element.size() - 2), names, k)));
  }
  return numbers;
}

}  // namespace scree::scenario
