#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/state_error.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

std::string StoredRange::text() const {
  const bool below = std::isfinite(least), above = std::isfinite(most);
  if (below && above) return fmt::format("from {:g} to {:.16g}", least, most);
  if (below) return least > 0 ? "above 0 and finite" : fmt::format("finite and {:g} or more", least);
  return "finite";
}

void StateTransfer::refuse(const std::string& name, const std::string& problem) const {
  throw StateError(
      fmt::format("'{}{}' {}; take a state that scree has written for this scene", group_, name, problem));
}

std::vector<std::size_t> StateTransfer::shape_of(std::size_t numbers, std::size_t width) {
  if (width == 1) return {numbers};
  return {width > 0 ? numbers / width : 0, width};
}

std::string StateTransfer::text_of(double number) { return fmt::format("{}", number); }

void StateTransfer::expect_shape(const std::string& name, const StateArray& array, const char* unit,
                                 const std::vector<std::size_t>& shape) const {
  // Rows of one number have two forms, and nothing has no width.
  const auto rows_of_one = [](const std::vector<std::size_t>& s) { return s.size() == 2 && s[1] == 1; };
  const bool same = array.shape == shape || (array.size() == 0 && !shape.empty()) ||
                    (rows_of_one(array.shape) && shape == std::vector{array.shape[0]}) ||
                    (rows_of_one(shape) && array.shape == std::vector{shape[0]});
  if (!same)
    refuse(name, fmt::format("has the shape ({}) instead of ({})", fmt::join(array.shape, ", "),
                             fmt::join(shape, ", ")));
  if (array.unit != unit) refuse(name, fmt::format("has another unit than \"{}\"", unit));
}

void StateTransfer::expect(const std::string& name, std::size_t found, std::size_t expected) const {
  if (found != expected) refuse(name, fmt::format("has {} instead of {}", counted(found, "value"), expected));
}

void StateTransfer::vectors(const std::string& name, const char* unit, const Vectors<double>& vectors,
                            int first, int last) const {
  const auto width = std::size_t(last - first);
  const std::size_t rows = width > 0 ? vectors[first].size() : 0;
  std::vector<double> all;
  if (restoring()) {
    all = found<double>(name);
    expect(name, all.size(), rows * width);
    expect_shape(name, get(name), unit, {rows, width});
    expect_range(name, all, stored::finite);
  } else {
    all.resize(rows * width);
  }
  for (std::size_t k = 0; k < width; ++k) {
    const Strided<double> component = vectors[first + int(k)];
    for (std::size_t i = 0; i < rows; ++i)
      restoring() ? void(component[i] = all[i * width + k]) : void(all[i * width + k] = component[i]);
  }
  if (!restoring()) put(name, {std::move(all), {rows, width}, unit});
}

}  // namespace scree
