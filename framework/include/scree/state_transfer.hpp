#pragma once

#include <algorithm>
#include <string>
#include <type_traits>

#include <scree/state.hpp>
#include <scree/strided.hpp>

namespace scree {

// Saves numbers into a state, or restores them from one, so that each part of a program lists what it keeps
// only once. Paths are relative to a group. Restoring throws Error if an array is missing, has another type
// of numbers or does not have the size that its owner expects.
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
  void value(const std::string& name, const char* unit, T& value) const;
  // Rows of `width` numbers in a container, which takes the size of the restored array.
  template <class Container>
  void rows(const std::string& name, const char* unit, Container& numbers, std::size_t width = 1) const;
  // The same for a container that has its size already.
  template <class Container>
  void sized_rows(const std::string& name, const char* unit, Container& numbers, std::size_t width = 1) const;
  // The same for a temporary, which is moved into the state when saving.
  template <class T>
  void moved_rows(const std::string& name, const char* unit, std::vector<T>& numbers,
                  std::size_t width = 1) const;
  // `count` numbers at an address.
  template <class T>
  void numbers(const std::string& name, const char* unit, T* data, std::size_t count) const;
  // The components [first, last) of a vector of all bodies, one row per body.
  void vectors(const std::string& name, const char* unit, const Vectors<double>& vectors, int first,
               int last) const;

 private:
  StateTransfer(State* to, const State* from, std::string group)
      : to_(to), from_(from), group_(std::move(group)) {}

  void put(const std::string& name, StateArray array) const { to_->put(group_ + name, std::move(array)); }
  const StateArray& get(const std::string& name) const { return from_->at(group_ + name); }
  static std::vector<std::size_t> shape_of(std::size_t numbers, std::size_t width);
  void expect(const std::string& name, std::size_t found, std::size_t expected) const;
  template <class T>
  const std::vector<T>& stored(const std::string& name) const;

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
const std::vector<T>& StateTransfer::stored(const std::string& name) const {
  const auto* numbers = std::get_if<std::vector<T>>(&get(name).values);
  if (!numbers) refuse(name, "has another type of numbers");
  return *numbers;
}

template <class T>
void StateTransfer::value(const std::string& name, const char* unit, T& value) const {
  if (!restoring()) return put(name, {std::vector<Stored<T>>{Stored<T>(value)}, {}, unit});
  const auto& numbers = stored<Stored<T>>(name);
  expect(name, numbers.size(), 1);
  value = T(numbers[0]);
}

template <class Container>
void StateTransfer::rows(const std::string& name, const char* unit, Container& numbers,
                         std::size_t width) const {
  if (restoring()) numbers.resize(stored<Stored<typename Container::value_type>>(name).size());
  sized_rows(name, unit, numbers, width);
}

template <class T>
void StateTransfer::moved_rows(const std::string& name, const char* unit, std::vector<T>& numbers,
                               std::size_t width) const {
  static_assert(std::is_same_v<T, Stored<T>>);
  if (restoring()) return sized_rows(name, unit, numbers, width);
  std::vector<std::size_t> shape = shape_of(numbers.size(), width);
  put(name, {std::move(numbers), std::move(shape), unit});
}

template <class Container>
void StateTransfer::sized_rows(const std::string& name, const char* unit, Container& numbers,
                               std::size_t width) const {
  using T = Stored<typename Container::value_type>;
  if (restoring()) {
    const std::vector<T>& all = stored<T>(name);
    expect(name, all.size(), numbers.size());
    std::copy(all.begin(), all.end(), numbers.begin());
    return;
  }
  put(name, {std::vector<T>(numbers.begin(), numbers.end()), shape_of(numbers.size(), width), unit});
}

template <class T>
void StateTransfer::numbers(const std::string& name, const char* unit, T* data, std::size_t count) const {
  if (!restoring()) return put(name, {std::vector<T>(data, data + count), {count}, unit});
  const std::vector<T>& all = stored<T>(name);
  expect(name, all.size(), count);
  std::copy(all.begin(), all.end(), data);
}

}  // namespace scree
