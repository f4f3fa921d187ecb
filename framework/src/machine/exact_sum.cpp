#include "machine/exact_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

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

void ExactSum::cover(std::size_t first, std::size_t end) {
  if (first_ == end_) first_ = end_ = first;
  while (first_ > first) digits_[--first_] = 0;
  while (end_ < end) digits_[end_++] = 0;
}

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
  // 53 bits of a term, shifted by up to 60, and 13 for the number of terms fit into 127.
  constexpr int below = 30, most_shift = 60, most_terms = 1 << 13;
  const int place = std::max(exponent, 1) - 1;
  if (in_window_ == 0) place_ = std::max(place - below, 0);
  const int shift = place - place_;
  if (shift < 0 || shift > most_shift || in_window_ == most_terms)
    return add_to_digits(mantissa, place, bits >> 63);
  const Signed shifted = Signed(mantissa) << shift;
  window_ += bits >> 63 ? -shifted : shifted;
  ++in_window_;
}

void ExactSum::add_to_digits(std::uint64_t mantissa, int place, bool negative) {
  constexpr std::size_t digits_of_term = 3;
  const auto first = std::size_t(place / digit_bits);
  cover(first, first + digits_of_term);
  Wide shifted = Wide(mantissa) << (place % digit_bits);
  for (std::size_t k = first; k < first + digits_of_term; ++k, shifted >>= digit_bits) {
    const auto digit = std::int64_t(std::uint64_t(shifted) & digit_mask);
    digits_[k] += negative ? -digit : digit;
  }
}

void ExactSum::spill(Signed window, int place) {
  const bool negative = window < 0;
  const Wide magnitude = negative ? -Wide(window) : Wide(window);
  if (const auto low = std::uint64_t(magnitude)) add_to_digits(low, place, negative);
  if (const auto high = std::uint64_t(magnitude >> 64)) add_to_digits(high, place + 64, negative);
}

void ExactSum::add(const ExactSum& other) {
  not_finite_ += other.not_finite_;
  spill(other.window_, other.place_);
  if (other.first_ == other.end_) return;
  cover(other.first_, other.end_);
  for (std::size_t k = other.first_; k < other.end_; ++k) digits_[k] += other.digits_[k];
}

std::int64_t ExactSum::carry() {
  std::int64_t over = 0;
  for (std::size_t k = first_; k < end_; ++k) {
    const std::int64_t digit = digits_[k] + over;
    over = digit >> digit_bits;
    digits_[k] = digit - (over << digit_bits);
  }
  return over;
}

// All digits, of which the last takes what is left over, and the numbers of NaN and of both infinities.
void ExactSum::write(Words words) const {
  ExactSum sum;
  sum.add(*this);
  sum.cover(0, digit_count);
  const std::int64_t over = sum.carry();
  std::copy(sum.digits_.begin(), sum.digits_.end(), words.begin());
  words[digit_count - 1] += over * (std::int64_t(1) << digit_bits);
  const double left = sum.not_finite_;
  words[digit_count] = std::isnan(left);
  words[digit_count + 1] = left > 0;
  words[digit_count + 2] = left < 0;
}

double ExactSum::value_of(std::span<const std::int64_t, word_count> words) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool not_a_number = words[digit_count] > 0, up = words[digit_count + 1] > 0,
             down = words[digit_count + 2] > 0;
  if (not_a_number || (up && down)) return std::numeric_limits<double>::quiet_NaN();
  if (up || down) return up ? infinity : -infinity;
  ExactSum sum;
  sum.cover(0, digit_count);
  std::copy_n(words.begin(), digit_count, sum.digits_.begin());
  return sum.value();
}

double ExactSum::value() const {
  if (not_finite_ != 0) return not_finite_;
  if (first_ == end_) {
    const double magnitude =
        rounded(window_ < 0 ? -Wide(window_) : Wide(window_), smallest_exponent + place_, false);
    return window_ < 0 ? -magnitude : magnitude;
  }
  ExactSum sum;
  sum.add(*this);
  // Two more digits take what the terms have carried.
  sum.cover(sum.first_, std::min(sum.end_ + 2, digit_count));
  const std::size_t first = sum.first_, end = sum.end_;
  Digits& digits = sum.digits_;
  const bool negative = sum.carry() < 0;
  if (negative) {
    for (std::size_t k = first; k < end; ++k) digits[k] = -digits[k];
    sum.carry();
  }
  std::size_t top = end;
  while (top > first && digits[top - 1] == 0) --top;
  if (top == first) return 0;
  const std::size_t low = top - first > 3 ? top - 3 : first;
  Wide number = 0;
  for (std::size_t k = top; k-- > low;) number = number << digit_bits | Wide(digits[k]);
  const bool more = std::any_of(digits.begin() + std::ptrdiff_t(first), digits.begin() + std::ptrdiff_t(low),
                                [](std::int64_t digit) { return digit != 0; });
  const double magnitude = rounded(number, smallest_exponent + digit_bits * int(low), more);
  return negative ? -magnitude : magnitude;
}

}  // namespace scree
