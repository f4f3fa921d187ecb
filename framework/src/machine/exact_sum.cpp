#include "machine/exact_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace scree {

namespace {

constexpr int digit_bits = 32, mantissa_bits = 52, smallest_exponent = -1074;
constexpr std::uint64_t digit_mask = (std::uint64_t(1) << digit_bits) - 1;

__extension__ typedef unsigned __int128 Wide;

int bit_length(Wide number) {
  const auto high = std::uint64_t(number >> 64), low = std::uint64_t(number);
  return high ? 64 + int(std::bit_width(high)) : int(std::bit_width(low));
}

// number · 2^exponent to the nearest double; `more`: the number has been cut off.
double rounded(Wide number, int exponent, bool more) {
  const int dropped = std::max(0, bit_length(number) - (mantissa_bits + 1));
  auto kept = std::uint64_t(number >> dropped);
  const Wide rest = number - (Wide(kept) << dropped), half = dropped ? Wide(1) << (dropped - 1) : 0;
  if (dropped && (rest > half || (rest == half && (more || kept % 2)))) ++kept;
  return std::ldexp(double(kept), exponent + dropped);
}

}  // namespace

void ExactSum::add(double term) {
  const auto bits = std::bit_cast<std::uint64_t>(term);
  const auto exponent = int(bits >> mantissa_bits & 0x7ff);
  if (exponent == 0x7ff) {
    not_finite_ += term;
    return;
  }
  std::uint64_t mantissa = bits & ((std::uint64_t(1) << mantissa_bits) - 1);
  if (exponent > 0) mantissa |= std::uint64_t(1) << mantissa_bits;
  if (mantissa == 0) return;
  const int place = std::max(exponent, 1) - 1;
  const auto first = std::size_t(place / digit_bits);
  Wide shifted = Wide(mantissa) << (place % digit_bits);
  for (std::size_t k = first; k < first + 3; ++k, shifted >>= digit_bits) {
    const auto digit = std::int64_t(std::uint64_t(shifted) & digit_mask);
    digits_[k] += bits >> 63 ? -digit : digit;
  }
  first_ = std::min(first_, first);
  last_ = std::max(last_, first + 2);
}

void ExactSum::add(const ExactSum& other) {
  for (std::size_t k = 0; k < digit_count; ++k) digits_[k] += other.digits_[k];
  first_ = std::min(first_, other.first_);
  last_ = std::max(last_, other.last_);
  not_finite_ += other.not_finite_;
}

double ExactSum::value() const {
  if (not_finite_ != 0) return not_finite_;
  if (first_ > last_) return 0;
  Digits digits = digits_;
  const auto carry = [&](std::size_t end) {
    std::int64_t over = 0;
    for (std::size_t k = first_; k < end; ++k) {
      const std::int64_t digit = digits[k] + over;
      over = digit >> digit_bits;
      digits[k] = digit - (over << digit_bits);
    }
    return over;
  };
  // Two more digits take what the terms have carried.
  const std::size_t end = std::min(last_ + 3, digit_count);
  const bool negative = carry(end) < 0;
  if (negative) {
    for (std::size_t k = first_; k < end; ++k) digits[k] = -digits[k];
    carry(end);
  }
  std::size_t top = end;
  while (top > first_ && digits[top - 1] == 0) --top;
  if (top == first_) return 0;
  const std::size_t low = top - first_ > 3 ? top - 3 : first_;
  Wide number = 0;
  for (std::size_t k = top; k-- > low;) number = number << digit_bits | Wide(digits[k]);
  const bool more = std::any_of(digits.begin() + std::ptrdiff_t(first_), digits.begin() + std::ptrdiff_t(low),
                                [](std::int64_t digit) { return digit != 0; });
  const double magnitude = rounded(number, smallest_exponent + digit_bits * int(low), more);
  return negative ? -magnitude : magnitude;
}

}  // namespace scree
