#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace scree {

// A sum of doubles that is rounded once, at its end, so that its bits do not depend on the order of the
// terms. Fixed-point number of 32-bit digits that covers all doubles; takes up to 2^30 terms. Infinities and
// NaN give what their sum is in any order.
class ExactSum {
 public:
  ExactSum() {}  // digits stay unset
  void add(double term);
  void add(const ExactSum& other);
  // The exact sum rounded to the nearest double, ties to even.
  double value() const;

  // The sum as integers: the integers of several sums, added one by one in any order, are those of the sum of
  // these sums; up to 2^20 of them.
  static constexpr std::size_t word_count = 71;
  using Words = std::span<std::int64_t, word_count>;
  void write(Words words) const;
  static double value_of(std::span<const std::int64_t, word_count> words);

 private:
  __extension__ typedef __int128 Signed;
  static constexpr std::size_t digit_count = 68;
  static_assert(word_count == digit_count + 3);
  using Digits = std::array<std::int64_t, digit_count>;

  // Adds mantissa · 2^(place − 1074) to the digits.
  void add_to_digits(std::uint64_t mantissa, int place, bool negative);
  void spill(Signed window, int place);
  // Extends [first_, end_) by zeros.
  void cover(std::size_t first, std::size_t end);
  // Makes each digit at least 0 and below 2^32; returns what is left over behind the last one.
  std::int64_t carry();

  // Terms of similar size: window_ · 2^(place_ − 1074).
  Signed window_ = 0;
  int place_ = 0, in_window_ = 0;
  // The others: digit k counts 2^(32 k − 1074); not normalised, and set within [first_, end_) alone.
  Digits digits_;
  std::size_t first_ = 0, end_ = 0;
  double not_finite_ = 0;
};

// The sum of term(item) over a range; a single item as it is.
template <class Items, class Term>
double exact_sum(const Items& items, const Term& term) {
  if (items.size() == 1) return term(*items.begin());
  ExactSum sum;
  for (const auto& item : items) sum.add(term(item));
  return sum.value();
}

}  // namespace scree
