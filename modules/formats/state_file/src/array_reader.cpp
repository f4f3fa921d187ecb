#include "array_reader.hpp"

#include "state_path.hpp"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::state_file {
namespace {

[[noreturn]] void refuse(const PlacedArray& place, std::string_view problem) {
  throw Error(fmt::format("'{}' {}", place.path, problem));
}

template <class T>
void from_lowest_byte_first(std::vector<T>& numbers) {
  if constexpr (std::endian::native != std::endian::little)
    for (T& number : numbers) {
      auto* bytes = reinterpret_cast<unsigned char*>(&number);
      std::reverse(bytes, bytes + sizeof(T));
    }
}

// Chooses the kind of values by its number; false if there is none.
template <std::size_t k = 0>
bool choose_kind(std::uint64_t kind, StateArray& array) {
  if constexpr (k == std::variant_size_v<decltype(array.values)>) {
    return false;
  } else {
    if (kind != k) return choose_kind<k + 1>(kind, array);
    array.values.template emplace<k>();
    return true;
  }
}

}  // namespace

std::uint64_t ArrayReader::bytes_of(const PlacedArray& place) {
  std::uint64_t bytes = place.width;
  bool fits = true;
  for (const std::uint64_t extent : place.shape)
    fits = fits && !__builtin_mul_overflow(bytes, extent, &bytes);
  if (!fits || bytes > bytes_left_) refuse(place, "claims more bytes than are in the file");
  if (bytes > 0 && (place.offset > file_bytes_ || bytes > file_bytes_ - place.offset))
    refuse(place, "lies beyond the end of the file");
  bytes_left_ -= bytes;
  memory_left_ -= double(bytes);
  if (memory_left_ < 0) refuse(place, "does not fit into memory with the arrays before it");
  return bytes;
}

void ArrayReader::read_bytes(const PlacedArray& place, void* to, std::uint64_t bytes) const {
  auto* at = static_cast<char*>(to);
  std::uint64_t from = place.offset;
  while (bytes > 0) {
    const ssize_t count = ::pread(descriptor_, at, bytes, off_t(from));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) refuse(place, "cannot be read from the disk");
    at += count, from += std::uint64_t(count), bytes -= std::uint64_t(count);
  }
}

template <class T>
std::vector<T> ArrayReader::values(const PlacedArray& place, std::uint64_t bytes) const {
  if (place.width != sizeof(T)) refuse(place, "has a type that no state has");
  std::vector<T> numbers(bytes / sizeof(T));
  read_bytes(place, numbers.data(), bytes);
  from_lowest_byte_first(numbers);
  return numbers;
}

template <>
std::vector<std::string> ArrayReader::values(const PlacedArray& place, std::uint64_t bytes) const {
  if (place.width == 0) refuse(place, "has texts without room");
  std::vector<char> all(bytes);
  read_bytes(place, all.data(), bytes);
  std::vector<std::string> texts(bytes / place.width);
  if (!place.lengths.empty() && place.lengths.size() != texts.size())
    refuse(place, "has no lengths for its texts");
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const std::string_view filled(all.data() + k * place.width, place.width);
    const std::size_t length =
        place.lengths.empty() ? filled.find_last_not_of('\0') + 1 : std::size_t(place.lengths[k]);
    if (length > place.width) refuse(place, "has texts longer than their room");
    texts[k] = filled.substr(0, length);
  }
  return texts;
}

StateArray ArrayReader::read(const PlacedArray& place) {
  if (!is_state_path(place.path))
    throw Error("there is an array whose name is not that of an array of a state");
  StateArray array;
  if (!choose_kind(place.kind, array)) refuse(place, "has a type that no state has");
  array.shape.assign(place.shape.begin(), place.shape.end());
  array.unit = place.unit;
  const std::uint64_t bytes = bytes_of(place);
  std::visit([&]<class T>(std::vector<T>& numbers) { numbers = values<T>(place, bytes); }, array.values);
  return array;
}

}  // namespace scree::state_file
