#include "plugins/program_checks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/plugin/program.hpp>

namespace scree {

namespace {

// How many numbers follow the number of a kind; for a kind that ends with a list, the fewest, and the list's
// numbers at a time.
struct Shape {
  std::size_t numbers;
  std::size_t list = 0;
};
constexpr Shape shapes[] = {{1}, {4}, {3}, {3}, {2, 2}, {5}, {7}, {4}, {4}, {6, 1}, {6, 2}};

bool fits(const std::vector<double>& data) {
  if (data.empty() || !(data[0] >= 0 && data[0] < double(std::size(shapes))) ||
      data[0] != std::floor(data[0]))
    return false;
  const Shape& shape = shapes[std::size_t(data[0])];
  const std::size_t count = data.size() - 1;
  return shape.list ? count >= shape.numbers && (count - shape.numbers) % shape.list == 0
                    : count == shape.numbers;
}

// Whether every second number from `first` on grows.
bool increases(const std::vector<double>& data, std::size_t first, bool strictly) {
  for (std::size_t k = first + 2; k < data.size(); k += 2)
    if (strictly ? !(data[k] > data[k - 2]) : data[k] < data[k - 2]) return false;
  return true;
}

std::optional<Error> drive_problem(const std::vector<double>& data) {
  const auto not_positive = [&](std::size_t k, const char* what) -> std::optional<Error> {
    if (data[k] > 0) return {};
    return Error("", fmt::format("has a {} of {:g}", what, data[k]), "give one above 0");
  };
  const auto kind = Program::Kind(int(data[0]));
  const bool rises = kind >= Program::drive && kind != Program::gaussian && kind != Program::ricker;
  if (rises && data[3] < 0)
    return Error("", fmt::format("rises within {:g} s", data[3]), "give a rise of 0 or more");
  switch (kind) {
    case Program::drive:
      return not_positive(4, "frequency");
    case Program::chirp:
      for (const std::size_t k : {4, 5})
        if (auto wrong = not_positive(k, "frequency")) return wrong;
      return not_positive(6, "duration");
    case Program::gaussian:
      return not_positive(4, "width");
    case Program::ricker:
      return not_positive(4, "frequency");
    case Program::noise:
      return not_positive(4, "lowest frequency");
    case Program::sweep:
      for (std::size_t k = 5; k < data.size(); k += 2)
        if (auto wrong = not_positive(k, "frequency")) return wrong;
      if (!increases(data, 6, true)) return Error("", "has decreasing times", "sort the steps");
      return not_positive(4, "duration");
    default:
      return {};
  }
}

}  // namespace

std::optional<Error> program_problem(const std::vector<double>& data) {
  if (data.size() > 2 && data[0] == double(Program::ahead) && std::isfinite(data[1]))
    return program_problem({data.begin() + 2, data.end()});
  if (!fits(data))
    return Error("", "is not a program (function of time)", "use one of the forms in program.hpp");
  if (!std::all_of(data.begin(), data.end(), [](double x) { return std::isfinite(x); }))
    return Error("", "contains a number that is not finite", "give finite numbers");
  const auto kind = Program::Kind(int(data[0]));
  if ((kind == Program::cycle || kind == Program::ramp) && !(data[3] > 0))
    return Error("", fmt::format("lasts {:g} s", data[3]), "give a period or duration above 0");
  if (kind == Program::table && !increases(data, 1, false))
    return Error("", "has decreasing times", "sort the rows");
  return drive_problem(data);
}

}  // namespace scree
