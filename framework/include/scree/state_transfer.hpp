#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include <scree/state.hpp>
#include <scree/strided.hpp>

namespace scree {

// Which numbers an array may have. A file may hold any, since others can write files with a right checksum.
struct StoredRange {
  double least = -std::numeric_limits<double>::infinity();  // included, like `most`
  double most = std::numeric_limits<double>::infinity();
  bool finite = true;

  template <class T>
  bool contains(T number) const;
  std::string text() const;  // for messages
};

namespace stored {
inline constexpr StoredRange finite{};
// Also infinity and NaN: what plug-ins keep is their own, and energies may have no value.
inline constexpr StoredRange any{.finite = false};
inline constexpr StoredRange non_negative{.least = 0};
inline constexpr StoredRange positive{.least = std::numeric_limits<double>::denorm_min()};
// From 0 on; for counts and indices.
constexpr StoredRange at_most(std::uint64_t most) { return {.least = 0, .most = double(most)}; }
// Truth values have two. An enumerator needs a range up to the last one.
template <class T>
constexpr StoredRange usual() {
  static_assert(!std::is_enum_v<T>, "give the range of the enumerators: stored::at_most(last)");
  return std::is_same_v<T, bool> ? at_most(1) : finite;
}
}  // namespace stored

// Saves numbers into a state, or restores them from one, so that each part of a program lists what it keeps
// only once. Paths are relative to a group. Restoring throws Error if an array is missing, has another type
// of numbers, another unit or another shape than its owner gives it, or a number out of its range: without a
// range one that is not finite. What depends on other arrays, such as an index, is checked by its owner, by a
// range or refuse().
class StateTransfer {
 public:
  static StateTransfer saving_to(State& state) { return {&state, nullptr, ""}; }
  static StateTransfer restoring_from(const State& state) { return {nullptr, &state, ""}; }

  bool restoring() const { return from_ != nullptr; }
  // The same state below a group, "contacts/0".
  StateTransfer below(const std::string& group) const { return {to_, from_, group_ + group + '/'}; }
  // Whether the state to restore from has an array; true when saving.
  bool has(const std::string& name) const { return !restoring() || from_->has(group_ + name); }
  // Error about an array: "<path>: <problem>; <cure>".
  [[noreturn]] void refuse(const std::string& name, const std::string& problem) const;

  // A single number, text, truth value or enumerator.
  template <class T>
  void value(const std::string& name, const char* unit, T& value,
             const StoredRange& range = stored::usual<T>()) const;
  // Rows of `width` numbers in a container, which takes the size of the restored array.
  template <class Container>
  void rows(const std::string& name, const char* unit, Container& numbers, std::size_t width = 1,
            const StoredRange& range = stored::usual<typename Container::value_type>()) const;
  // The same for a container that has its size already.
  template <class Container>
  void sized_rows(const std::string& name, const char* unit, Container& numbers, std::size_t width = 1,
                  const StoredRange& range = stored::usual<typename Container::value_type>()) const;
  // The same for a temporary, which is moved into the state when saving.
  template <class T>
  void moved_rows(const std::string& name, const char* unit, std::vector<T>& numbers, std::size_t width = 1,
                  const StoredRange& range = stored::finite) const;
  // `count` numbers at an address.
  template <class T>
  void numbers(const std::string& name, const char* unit, T* data, std::size_t count,
               const StoredRange& range = stored::finite) const;
  // The components [first, last) of a vector of all bodies, one row per body.
  void vectors(const std::string& name, const char* unit, const Vectors<double>& vectors, int first,
               int last) const;

 private:
  StateTransfer(State* to, const State* from, std::string group)
      : to_(to), from_(from), group_(std::move(group)) {}

  void put(const std::string& name, StateArray array) const { to_->put(group_ + name, std::move(array)); }
  const StateArray& get(const std::string& name) const { return from_->at(group_ + name); }
  static std::vector<std::size_t> shape_of(std::size_t numbers, std::size_t width);
  static std::string text_of(double number);
  void expect(const std::string& name, std::size_t found, std::size_t expected) const;
  void expect_shape(const std::string& name, const StateArray& array, const char* unit,
                    const std::vector<std::size_t>& shape) const;
  template <class T>
  void expect_range(const std::string& name, const std::vector<T>& numbers, const StoredRange& range) const;
  // The numbers of an array.
  template <class T>
  const std::vector<T>& found(const std::string& name) const;
  // The same, checked: of a single value, or of rows.
  template <class T>
  T checked_value(const std::string& name, const char* unit, const StoredRange& range) const;
  template <class T>
  const std::vector<T>& checked_rows(const std::string& name, const char* unit, std::size_t width,
                                     const StoredRange& range) const;

  State* to_;
  const State* from_;
  std::string group_;
};

// The type in which a state stores values of a type.
template <class T>
struct StoredAs {
  using type = T;
};
template <class T>
requires(std::is_enum_v<T> || std::is_same_v<T, bool>) struct StoredAs<T> {
  using type = std::uint8_t;
};
template <class T>
using Stored = typename StoredAs<T>::type;

template <class T>
bool StoredRange::contains(T number) const {
  if constexpr (std::is_floating_point_v<T>)
    if (!finite && !std::isfinite(number)) return true;
  if constexpr (std::is_arithmetic_v<T>)
    return double(number) >= least && double(number) <= most && std::isfinite(double(number));
  return true;  // a text
}

template <class T>
void StateTransfer::expect_range(const std::string& name, const std::vector<T>& numbers,
                                 const StoredRange& range) const {
  for (const T& number : numbers)
    if (!range.contains(number))
      if constexpr (std::is_arithmetic_v<T>)
        refuse(name, "has the number " + text_of(double(number)) + ", which is not " + range.text());
}

template <class T>
const std::vector<T>& StateTransfer::found(const std::string& name) const {
  const auto* numbers = std::get_if<std::vector<T>>(&get(name).values);
  if (!numbers) refuse(name, "has another type of numbers");
  return *numbers;
}

template <class T>
T StateTransfer::checked_value(const std::string& name, const char* unit, const StoredRange& range) const {
  const std::vector<T>& all = found<T>(name);
  expect(name, all.size(), 1);
  expect_shape(name, get(name), unit, {});
  expect_range(name, all, range);
  return all[0];
}

template <class T>
const std::vector<T>& StateTransfer::checked_rows(const std::string& name, const char* unit,
                                                  std::size_t width, const StoredRange& range) const {
  const std::vector<T>& all = found<T>(name);
  expect_shape(name, get(name), unit, shape_of(all.size(), width));
  expect_range(name, all, range);
  return all;
}

template <class T>
void StateTransfer::value(const std::string& name, const char* unit, T& value,
                          const StoredRange& range) const {
  if (!restoring()) return put(name, {std::vector<Stored<T>>{Stored<T>(value)}, {}, unit});
  value = T(checked_value<Stored<T>>(name, unit, range));
}

template <class Container>
void StateTransfer::rows(const std::string& name, const char* unit, Container& numbers, std::size_t width,
                         const StoredRange& range) const {
  if (restoring()) numbers.resize(found<Stored<typename Container::value_type>>(name).size());
  sized_rows(name, unit, numbers, width, range);
}

template <class T>
void StateTransfer::moved_rows(const std::string& name, const char* unit, std::vector<T>& numbers,
                               std::size_t width, const StoredRange& range) const {
  static_assert(std::is_same_v<T, Stored<T>>);
  if (restoring()) return sized_rows(name, unit, numbers, width, range);
  std::vector<std::size_t> shape = shape_of(numbers.size(), width);
  put(name, {std::move(numbers), std::move(shape), unit});
}

template <class Container>
void StateTransfer::sized_rows(const std::string& name, const char* unit, Container& numbers,
                               std::size_t width, const StoredRange& range) const {
  using T = Stored<typename Container::value_type>;
  if (restoring()) {
    expect(name, found<T>(name).size(), numbers.size());
    const std::vector<T>& all = checked_rows<T>(name, unit, width, range);
    std::copy(all.begin(), all.end(), numbers.begin());
    return;
  }
  put(name, {std::vector<T>(numbers.begin(), numbers.end()), shape_of(numbers.size(), width), unit});
}

template <class T>
void StateTransfer::numbers(const std::string& name, const char* unit, T* data, std::size_t count,
                            const StoredRange& range) const {
  if (!restoring()) return put(name, {std::vector<T>(data, data + count), {count}, unit});
  expect(name, found<T>(name).size(), count);
  const std::vector<T>& all = checked_rows<T>(name, unit, 1, range);
  std::copy(all.begin(), all.end(), data);
}

}  // namespace scree
