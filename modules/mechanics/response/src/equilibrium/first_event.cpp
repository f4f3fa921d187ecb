#include "equilibrium/first_event.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace scree::response {

namespace {

// Events before this fraction belong to the event at which the previous increment ended.
constexpr double early = 1e-3;
// Fraction of the increment to which an event is located. The error of a spring is reduced to this fraction.
constexpr double close = 1e-4;
// Fraction of the way to the expected event that is taken, so that it is approached from before.
constexpr double caution = 0.999;
constexpr int most_evaluations = 40;
// With more events in an increment none is located: each costs several searches, and each matters less.
constexpr std::size_t most_events = 8;

bool touches(PairStatus status) { return status != PairStatus::open; }

bool slides(const PairState& pair) { return pair.status == PairStatus::slides; }

// Fraction of an increment at which a number reaches `limit`, extrapolated from two values.
double share_at(double limit, double before_share, double before, double last_share, double last) {
  return last_share + (limit - last) * (last_share - before_share) / (last - before);
}

}  // namespace

FirstEvent::FirstEvent(Equilibrium& equilibrium, const StaticConfiguration& from, double time,
                       double increment, Balance whole, const std::function<bool()>& proceed)
    : equilibrium_(equilibrium),
      from_(from),
      time_(time),
      increment_(increment),
      proceed_(proceed),
      balance_(std::move(whole)),
      before_{0, equilibrium.contacts().states_before(), {}},
      last_(before_),
      beyond_{1, equilibrium.contacts().states_after(), balance_.motion},
      whole_(beyond_) {}

double FirstEvent::find() {
  const auto any_slides = [](const Point& at) {
    return std::any_of(at.states.begin(), at.states.end(), slides);
  };
  const std::size_t count = events(before_, beyond_).size();
  if (count == 0 || count > most_events || !any_slides(before_)) return 1;  // the end was evaluated last
  if (!evaluate(early)) return end_at(whole_);
  last_ = std::move(point_);
  if (events(last_, beyond_).empty() || !any_slides(last_)) return end_at(whole_);
  approach();
  if (last_.share > 1 - close) return end_at(whole_);
  const double share = end_at(last_);
  return share > 0 ? share : end_at(whole_);
}

void FirstEvent::approach() {
  for (int k = 0; k < most_evaluations && beyond_.share - last_.share > close; ++k) {
    const double next = expected();
    if (next - last_.share < close || !evaluate(next)) return;
    if (events(last_, point_).empty())
      before_ = std::exchange(last_, std::move(point_));
    else
      beyond_ = std::move(point_);
  }
}

double FirstEvent::end_at(const Point& point) {
  balance_ = equilibrium_.find(from_, time_ + point.share * increment_, point.motion, proceed_);
  return balance_.found ? point.share : 0;
}

std::vector<std::size_t> FirstEvent::events(const Point& a, const Point& b) const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < a.states.size(); ++i) {
    const PairStatus from = a.states[i].status, to = b.states[i].status;
    if (touches(from) != touches(to) || (from == PairStatus::sticks && to == PairStatus::slides))
      all.push_back(i);
  }
  return all;
}

bool FirstEvent::evaluate(double share) {
  // Between the balances on both sides.
  const double between = (share - last_.share) / (beyond_.share - last_.share);
  Eigen::VectorXd guess = between * beyond_.motion;
  if (last_.motion.size() > 0) guess += (1 - between) * last_.motion;
  balance_ = equilibrium_.find(from_, time_ + share * increment_, guess, proceed_);
  point_ = {share, equilibrium_.contacts().states_after(), balance_.motion};
  return balance_.found;
}

double FirstEvent::expected() const {
  double first = std::numeric_limits<double>::infinity();
  for (const std::size_t i : events(last_, beyond_)) {
    const PairState &a = before_.states[i], &b = last_.states[i], &c = beyond_.states[i];
    const double share = touches(b.status) == touches(c.status)
                             ? share_at(c.mobilised, before_.share, a.mobilised, last_.share, b.mobilised)
                             : share_at(0, before_.share, a.overlap, last_.share, b.overlap);
    if (share >= last_.share) first = std::min(first, share);
  }
  if (!(first < beyond_.share)) return 0.5 * (last_.share + beyond_.share);
  return first - last_.share < close ? first : last_.share + caution * (first - last_.share);
}

}  // namespace scree::response
