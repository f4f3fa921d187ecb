#include "ranks/rank_sums.hpp"

#include <algorithm>

namespace scree {

// Only the rank that has the tile gives other bits than 0, which are the sum of the bits of all ranks.
void RankSums::add_single(double& target, double term) {
  singles_.push_back(&target);
  bits_of_singles_.push_back(std::bit_cast<std::int64_t>(term));
}

void RankSums::add(double& target, const ExactSum& sum) {
  sums_.push_back(&target);
  words_of_sums_.resize(words_of_sums_.size() + ExactSum::word_count);
  sum.write(std::span(words_of_sums_).last<ExactSum::word_count>());
}

void RankSums::close() {
  if (!ranks_) return;
  std::vector<double> largest;
  for (const double* const number : largest_) largest.push_back(*number);
  std::vector<std::int64_t> sums = bits_of_singles_;
  sums.insert(sums.end(), words_of_sums_.begin(), words_of_sums_.end());
  for (const bool* const flag : flags_) sums.push_back(*flag ? 0 : 1);
  for (const std::int64_t* const count : counts_) sums.push_back(*count);
  ranks_->combine(largest, sums);
  for (std::size_t k = 0; k < largest.size(); ++k) *largest_[k] = largest[k];
  const std::int64_t* next = sums.data();
  for (double* const single : singles_) *single = std::bit_cast<double>(*next++);
  for (double* const target : sums_) {
    *target =
        ExactSum::value_of(std::span<const std::int64_t, ExactSum::word_count>(next, ExactSum::word_count));
    next += ExactSum::word_count;
  }
  for (bool* const flag : flags_) *flag = *next++ == 0;
  for (std::int64_t* const count : counts_) *count = *next++;
}

}  // namespace scree
