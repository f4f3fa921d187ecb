#include "state/state_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

namespace scree {

namespace {

class Writer {
 public:
  void add(std::uint64_t number) { add_all(&number, 1); }
  void add(const std::string& text) {
    add(text.size());
    add_all(text.data(), text.size());
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.size());
    if constexpr (std::is_same_v<T, std::string>)
      for (const std::string& text : values) add(text);
    else
      add_all(values.data(), values.size());
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  template <class T>
  void add_all(const T* values, std::size_t count) {
    const auto* const begin = reinterpret_cast<const std::byte*>(values);
    bytes_.insert(bytes_.end(), begin, begin + count * sizeof(T));
  }
  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  explicit Reader(const std::vector<std::byte>& bytes) : next_(bytes.data()) {}

  std::uint64_t number() {
    std::uint64_t number = 0;
    take(&number, 1);
    return number;
  }
  std::string text() {
    std::string text(number(), '\0');
    take(text.data(), text.size());
    return text;
  }
  template <class T>
  void fill(std::vector<T>& values) {
    values.resize(number());
    if constexpr (std::is_same_v<T, std::string>)
      for (std::string& value : values) value = text();
    else
      take(values.data(), values.size());
  }

 private:
  template <class T>
  void take(T* values, std::size_t count) {
    if (count > 0) std::memcpy(values, next_, count * sizeof(T));
    next_ += count * sizeof(T);
  }
  const std::byte* next_;
};

using Values = decltype(StateArray::values);

// An empty array of the type with a number in the variant.
template <std::size_t k = 0>
Values values_of_type(std::size_t type) {
  if constexpr (k < std::variant_size_v<Values>)
    return type == k ? Values(std::in_place_index<k>) : values_of_type<k + 1>(type);
  else
    return {};
}

}  // namespace

std::vector<std::byte> bytes_of(const State& state) {
  Writer writer;
  writer.add(state.arrays().size());
  for (const auto& [path, array] : state.arrays()) {
    writer.add(path);
    writer.add(array.unit);
    writer.add(array.shape);
    writer.add(array.values.index());
    std::visit([&](const auto& values) { writer.add(values); }, array.values);
  }
  return writer.take();
}

State state_of(const std::vector<std::byte>& bytes) {
  Reader reader(bytes);
  State state;
  for (std::uint64_t left = reader.number(); left > 0; --left) {
    const std::string path = reader.text();
    StateArray array;
    array.unit = reader.text();
    reader.fill(array.shape);
    array.values = values_of_type(reader.number());
    std::visit([&](auto& values) { reader.fill(values); }, array.values);
    state.put(path, std::move(array));
  }
  return state;
}

}  // namespace scree
