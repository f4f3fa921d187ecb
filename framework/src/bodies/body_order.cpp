#include <utility>

#include <scree/body_order.hpp>

namespace scree {

BodyOrder::BodyOrder(std::vector<std::uint32_t> numbers) {
  bool rearranged = false;
  for (std::size_t place = 0; place < numbers.size(); ++place)
    rearranged = rearranged || numbers[place] != place;
  if (!rearranged) return;
  place_ = inverse_of(numbers);
  number_ = std::move(numbers);
}

BodyOrder BodyOrder::moved(const std::vector<std::uint32_t>& from) const {
  std::vector<std::uint32_t> numbers(from.size());
  for (std::size_t place = 0; place < from.size(); ++place) numbers[place] = number(from[place]);
  return BodyOrder(std::move(numbers));
}

std::vector<std::uint32_t> inverse_of(const std::vector<std::uint32_t>& permutation) {
  std::vector<std::uint32_t> inverse(permutation.size());
  for (std::size_t k = 0; k < permutation.size(); ++k) inverse[permutation[k]] = std::uint32_t(k);
  return inverse;
}

}  // namespace scree
