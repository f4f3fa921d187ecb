#include "surfaces/sliding_work.hpp"

#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/ranks.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

namespace {

// Sums are multiples of 2^-places J, below 2^27 J = 1.3e8 J.
constexpr int places = 100;
constexpr double largest_term = 1e8;  // (J)

}  // namespace

SlidingWork::SlidingWork(const WallSurfaces& surfaces, int dimension) : first_{0} {
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (is_infinite(surfaces.shapes[s], dimension))
      throw Error(fmt::format(
          "surface {} is infinite, so that sliding work on its facets has no map; give it a length, "
          "or set snapshot.sliding_work = false",
          surfaces.names[s]));
    facets_.emplace_back(surfaces.shapes[s], surfaces.meshes[s].get(), dimension);
    first_.push_back(first_.back() + facets_.back().size());
  }
  sums_.assign(first_.back(), 0);
}

void SlidingWork::add(const Slip& slip) {
  if (!(std::abs(slip.energy) < largest_term)) return;  // the step is refused for its speed
  sums_[first_[slip.surface] + slip.facet] += Fixed(std::round(std::ldexp(slip.energy, places)));
}

std::vector<double> SlidingWork::of(std::size_t surface) const {
  std::vector<double> work;
  for (std::size_t k = first_[surface]; k < first_[surface + 1]; ++k)
    work.push_back(std::ldexp(double(sums_[k]), -places));
  return work;
}

void SlidingWork::clear() { sums_.assign(sums_.size(), 0); }

std::array<std::int64_t, SlidingWork::digit_count> SlidingWork::digits_of(Fixed sum) {
  std::array<std::int64_t, digit_count> digits = {};
  for (std::size_t k = 0; k + 1 < digit_count; ++k, sum >>= 32) digits[k] = std::int64_t(sum & 0xffffffff);
  digits.back() = std::int64_t(sum);
  return digits;
}

SlidingWork::Fixed SlidingWork::sum_of(const std::int64_t* digits) {
  Fixed sum = 0;
  for (std::size_t k = digit_count; k-- > 0;) sum = sum * (Fixed(1) << 32) + digits[k];
  return sum;
}

std::vector<std::int64_t> SlidingWork::digits() const {
  std::vector<std::int64_t> all;
  for (const Fixed sum : sums_)
    for (const std::int64_t digit : digits_of(sum)) all.push_back(digit);
  return all;
}

void SlidingWork::set(const std::vector<std::int64_t>& digits) {
  for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k] = sum_of(digits.data() + digit_count * k);
}

void SlidingWork::gather(Ranks& ranks) {
  std::vector<std::int64_t> all = digits();
  ranks.combine({}, all);
  if (ranks.rank() == 0)
    set(all);
  else
    clear();
}

void SlidingWork::transfer(const StateTransfer& state) {
  std::vector<std::int64_t> all = digits();
  state.sized_rows("sliding_work", "2^-100 J", all, digit_count);
  if (state.restoring()) set(all);
}

}  // namespace scree
