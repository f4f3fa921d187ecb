#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <scree/state.hpp>

namespace scree::fuzz {

// Numbers of an input, which never end.
class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool is_left() const { return at_ < bytes_.size(); }
  std::size_t below(std::size_t bound) {
    std::size_t number = next() * 256;
    number += next();
    return bound == 0 ? 0 : number % bound;
  }

 private:
  std::size_t next() { return is_left() ? bytes_[at_++] : 0; }
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

template <class T>
T odd_number(Input& input) {
  using Limits = std::numeric_limits<T>;
  const T large = Limits::max() > T(100) ? T(Limits::max() / 3) : T(100), half = T(1) / T(2);
  const T numbers[] = {T(0),
                       T(-1),
                       T(1),
                       T(2),
                       T(3),
                       T(27),
                       T(-27),
                       half,
                       large,
                       Limits::max(),
                       Limits::lowest(),
                       Limits::min(),
                       Limits::infinity(),
                       Limits::quiet_NaN()};
  return numbers[input.below(std::size(numbers))];
}

template <class T>
void change_values(std::vector<T>& values, Input& input) {
  if (values.empty()) return;
  T& value = values[input.below(values.size())];
  if constexpr (std::is_same_v<T, std::string>) {
    const std::size_t at = input.below(value.size() + 1);
    static constexpr const char* pieces[] = {"", "9", "-", "\x1b[2J", "\n", "nan", "= 0\n", "x"};
    value.replace(at, input.below(4), pieces[input.below(std::size(pieces))]);
  } else {
    value = odd_number<T>(input);
  }
}

// One value, or the number, shape, type or unit of the values of an array, or the array left out.
inline void change_array(State& state, const std::string& path, Input& input) {
  StateArray array = state.at(path);
  const auto resize = [&](std::ptrdiff_t by) {
    std::visit(
        [&](auto& values) { values.resize(std::max<std::ptrdiff_t>(0, std::ptrdiff_t(values.size()) + by)); },
        array.values);
    array.shape = {array.size()};
  };
  switch (input.below(12)) {
    case 0:
      resize(1);
      break;
    case 1:
      resize(-1);
      break;
    case 2:
      resize(std::numeric_limits<std::int16_t>::min());
      break;
    case 3:
      array.shape = {1, array.size()};
      break;
    case 4:
      array.values = std::vector<double>(array.size());
      break;
    case 5:
      array.values = std::vector<std::uint64_t>(array.size());
      break;
    case 6:
      array.unit = "K";
      break;
    default:
      std::visit([&](auto& values) { change_values(values, input); }, array.values);
  }
  state.put(path, std::move(array));
}

// A state with changes that the input chooses, and another hash, which need not fit. texts: whether a text
// was changed.
inline State changed(State state, std::span<const std::uint8_t> bytes, bool& texts) {
  std::vector<std::string> paths;
  for (const auto& [path, array] : state.arrays()) paths.push_back(path);
  state.put("state_hash", {std::vector<std::uint64_t>{0}, {}, ""});
  Input input(bytes);
  for (int k = 0; k < 3 && input.is_left(); ++k) {
    const std::string& path = paths[input.below(paths.size())];
    texts |= std::holds_alternative<std::vector<std::string>>(state.at(path).values);
    change_array(state, path, input);
  }
  return state;
}

}  // namespace scree::fuzz
