#include <cstring>

#include <fmt/format.h>

#include <scree/state.hpp>
#include <scree/state_error.hpp>

namespace scree {

std::size_t StateArray::size() const {
  return std::visit([](const auto& numbers) { return numbers.size(); }, values);
}

bool operator==(const StateArray& a, const StateArray& b) {
  if (a.shape != b.shape || a.unit != b.unit || a.values.index() != b.values.index()) return false;
  return std::visit(
      [&]<class T>(const std::vector<T>& of_a) {
        const auto& of_b = std::get<std::vector<T>>(b.values);
        if constexpr (std::is_same_v<T, std::string>)
          return of_a == of_b;
        else
          return of_a.size() == of_b.size() &&
                 (of_a.empty() || std::memcmp(of_a.data(), of_b.data(), of_a.size() * sizeof(T)) == 0);
      },
      a.values);
}

const StateArray& State::at(std::string_view path) const {
  const auto found = arrays_.find(path);
  if (found == arrays_.end())
    throw StateError(
        fmt::format("the state has no '{}'; take one that this version of scree has written", path));
  return found->second;
}

}  // namespace scree
