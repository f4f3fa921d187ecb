#include "ranks/rank_sums.hpp"

#include <algorithm>

namespace scree {

// Only the rank that has the tile gives other bits than 0, which are the sum of the bits of all ranks.
void RankSums::add_single(double& target, double term) {
  message_->singles.push_back(&target);
  message_->bits_of_singles.push_back(std::bit_cast<std::int64_t>(term));
}

void RankSums::add(double& target, const ExactSum& sum) {
  message_->sums.push_back(&target);
  std::vector<std::int64_t>& words = message_->words_of_sums;
  words.resize(words.size() + ExactSum::word_count);
  sum.write(std::span(words).last<ExactSum::word_count>());
}

void RankSums::exchange() {
  const Message& m = *message_;
  std::vector<double> largest;
  for (const double* const number : m.largest) largest.push_back(*number);
  std::vector<std::int64_t> sums = m.bits_of_singles;
  sums.insert(sums.end(), m.words_of_sums.begin(), m.words_of_sums.end());
  for (const bool* const flag : m.flags) sums.push_back(*flag ? 0 : 1);
  for (const std::int64_t* const count : m.counts) sums.push_back(*count);
  m.ranks.combine(largest, sums);
  for (std::size_t k = 0; k < largest.size(); ++k) *m.largest[k] = largest[k];
  const std::int64_t* next = sums.data();
  for (double* const single : m.singles) *single = std::bit_cast<double>(*next++);
  for (double* const target : m.sums) {
    *target =
        ExactSum::value_of(std::span<const std::int64_t, ExactSum::word_count>(next, ExactSum::word_count));
    next += ExactSum::word_count;
  }
  for (bool* const flag : m.flags) *flag = *next++ == 0;
  for (std::int64_t* const count : m.counts) *count = *next++;
}

}  // namespace scree
