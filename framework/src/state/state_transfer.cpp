#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

void StateTransfer::refuse(const std::string& name, const std::string& problem) const {
  throw Error(
      fmt::format("'{}{}' {}; take a state that scree has written for this scene", group_, name, problem));
}

std::vector<std::size_t> StateTransfer::shape_of(std::size_t numbers, std::size_t width) {
  if (width == 1) return {numbers};
  return {width > 0 ? numbers / width : 0, width};
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
    all = stored<double>(name);
    expect(name, all.size(), rows * width);
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
