#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/state.hpp>

namespace scree {

std::size_t StateArray::size() const {
  return std::visit([](const auto& numbers) { return numbers.size(); }, values);
}

const StateArray& State::at(std::string_view path) const {
  const auto found = arrays_.find(path);
  if (found == arrays_.end())
    throw Error(fmt::format("the state has no '{}'; take one that this version of scree has written", path));
  return found->second;
}

std::size_t State::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [path, array] : arrays_)
    bytes +=
        std::visit([](const auto& numbers) { return numbers.size() * sizeof(numbers[0]); }, array.values);
  return bytes;
}

}  // namespace scree
