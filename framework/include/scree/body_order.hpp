#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scree {

// Places of bodies in memory. A body keeps its number, by which the scene, probes and files list it; its
// place changes when bodies are sorted again, so that neighbours are near in memory.
class BodyOrder {
 public:
  // Each body at the place of its number.
  BodyOrder() = default;
  // The numbers of the bodies in the order of their places: a permutation.
  explicit BodyOrder(std::vector<std::uint32_t> numbers);

  // Whether a body is at another place than its number.
  bool rearranged() const { return !number_.empty(); }
  std::uint32_t number(std::size_t place) const {
    return rearranged() ? number_[place] : std::uint32_t(place);
  }
  std::uint32_t place(std::size_t number) const {
    return rearranged() ? place_[number] : std::uint32_t(number);
  }
  // By place; empty if no body is rearranged.
  const std::vector<std::uint32_t>& numbers() const { return number_; }

  // The order after each place has taken the body at the place `from[place]`.
  BodyOrder moved(const std::vector<std::uint32_t>& from) const;
  // Of each place, the place that has its body in scene order: moved(back()) is not rearranged.
  const std::vector<std::uint32_t>& back() const { return place_; }

 private:
  std::vector<std::uint32_t> number_, place_;
};

// Of a permutation: the index at which it has each number.
std::vector<std::uint32_t> inverse_of(const std::vector<std::uint32_t>& permutation);

// Rearranges rows of `width` numbers: row i becomes what row from[i] was.
template <class Container>
void rearrange_rows(Container& numbers, std::size_t width, const std::vector<std::uint32_t>& from) {
  if (numbers.empty()) return;
  Container rearranged(numbers.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    for (std::size_t k = 0; k < width; ++k) rearranged[i * width + k] = numbers[from[i] * width + k];
  numbers = std::move(rearranged);
}

// Copies rows of `width` numbers, sorted by place, into rows sorted by number. Rows behind the last body are
// not copied.
template <class Container>
void copy_rows(const Container& by_place, std::size_t width, const BodyOrder& order, Container& by_number) {
  if (by_place.empty()) return;
  for (std::size_t place = 0; place < order.numbers().size(); ++place)
    for (std::size_t k = 0; k < width; ++k)
      by_number[order.number(place) * width + k] = by_place[place * width + k];
}

// The same for bodies of some numbers.
template <class Container>
void copy_rows(const Container& by_place, std::size_t width, const BodyOrder& order, Container& by_number,
               const std::vector<std::uint32_t>& numbers) {
  if (by_place.empty()) return;
  for (const std::uint32_t number : numbers)
    for (std::size_t k = 0; k < width; ++k)
      by_number[number * width + k] = by_place[order.place(number) * width + k];
}

}  // namespace scree
