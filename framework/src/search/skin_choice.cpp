#include "search/skin_choice.hpp"

#include <algorithm>
#include <cmath>

#include <scree/state_transfer.hpp>

namespace scree {

namespace {

// Cost of a search per body, in evaluations of one pair; measured on beads-4096.
constexpr double search_per_body = 15;
// Smallest skin, relative to the first.
constexpr double min_skin_ratio = 1e-2;

}  // namespace

// Cost per step for a skin s, in pair evaluations: n + ρ s for n touching pairs and ρ further listed pairs
// per skin; a list lasts s/(2u) steps at a travel u per step, so that a search of cost C adds 2u C/s.
// Minimum: s² = 2u C/ρ.
double SkinChoice::optimal_skin(const ListStatistics& list) const {
  const double per_skin = std::max(list.listed - list.touching, 1.0) / list.skin;
  const double travel = list.travelled / double(std::max<std::uint64_t>(list.steps, 1));
  const double skin = std::sqrt(2 * travel * search_per_body * list.bodies / per_skin);
  return std::clamp(skin, std::min(std::max(min_skin_ratio * first_, least_), max_skin_), max_skin_);
}

double SkinChoice::next_skin(const ListStatistics& list) {
  next_review_ = first_review;
  const double most = std::min(std::max(2 * list.skin, least_), max_skin_);
  return std::clamp(optimal_skin(list), std::min(0.5 * list.skin, most), most);
}

double SkinChoice::reviewed_skin(const ListStatistics& list) {
  const double skin = optimal_skin(list);
  const double saved = (list.listed - list.touching) * (1 - skin / list.skin) * double(list.steps);
  if (saved < search_per_body * list.bodies) {
    next_review_ *= 4;
    return list.skin;
  }
  next_review_ = first_review;
  return skin;
}

void SkinChoice::transfer(const StateTransfer& state) { state.value("next_review", "1", next_review_); }

}  // namespace scree
