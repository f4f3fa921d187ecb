#include "search/skin_choice.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

// What a search costs for each body, in evaluations of one pair: measured on beads-4096.
constexpr double search_per_body = 15;
// The thinnest skin, in those of the start.
constexpr double thinnest = 1e-2;

}  // namespace

// Pairs cost n + ρ s a step for a skin s, with n that touch and ρ of the list; a list lives s/(2u) steps at u
// a step, so that its search costs 2u C/s a step. The least is at s² = 2u C/ρ.
double SkinChoice::best(const ListStatistics& list) const {
  const double per_skin = std::max(list.listed - list.touching, 1.0) / list.skin;
  const double way = list.travelled / double(std::max<std::uint64_t>(list.steps, 1));
  const double skin = std::sqrt(2 * way * search_per_body * list.bodies / per_skin);
  return std::clamp(skin, thinnest * first_, max_skin_);
}

double SkinChoice::after(const ListStatistics& list) {
  next_review_ = first_review;
  return std::clamp(best(list), 0.5 * list.skin, std::min(2 * list.skin, max_skin_));
}

double SkinChoice::review(const ListStatistics& list) {
  const double skin = best(list);
  const double saved = (list.listed - list.touching) * (1 - skin / list.skin) * double(list.steps);
  if (saved < search_per_body * list.bodies) {
    next_review_ *= 4;
    return list.skin;
  }
  next_review_ = first_review;
  return skin;
}

}  // namespace scree
