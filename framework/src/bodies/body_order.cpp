#include <utility>

#include <scree/body_order.hpp>

namespace scree {

BodyOrder::BodyOrder(std::vector<std::uint32_t> numbers)
    : number_(std::move(numbers)), place_(number_.size()) {
  bool rearranged = false;
  for (std::size_t place = 0; place < number_.size(); ++place) {
    place_[number_[place]] = std::uint32_t(place);
    rearranged = rearranged || number_[place] != place;
  }
  if (!rearranged) number_.clear(), place_.clear();
}

BodyOrder BodyOrder::moved(const std::vector<std::uint32_t>& from) const {
  std::vector<std::uint32_t> numbers(from.size());
  for (std::size_t place = 0; place < from.size(); ++place) numbers[place] = number(from[place]);
  return BodyOrder(std::move(numbers));
}

}  // namespace scree
