#pragma once

#include "equilibrium/equilibrium.hpp"

namespace scree::response {

// Finds the first event within an increment during which contacts slide: another contact begins to slide,
// touches or parts. Slip may end or turn there. A law sees an increment as a whole, so that slip which ends
// or turns within it leaves an error of the spring in proportion to the increment. Therefore the increment
// should end at the event.
class FirstEvent {
 public:
  // An increment (s) from a time (s) and a configuration; whole: the balance at its end, which was found
  // last.
  FirstEvent(Equilibrium& equilibrium, const StaticConfiguration& from, double time, double increment,
             Balance whole, const std::function<bool()>& proceed);

  // Fraction of the increment at which the first event occurs. 1: no event, or the search failed on the way.
  // 0: no equilibrium at that point. The equilibrium is evaluated there last.
  double find();
  Balance take_balance() { return std::move(balance_); }

 private:
  // A balance at a fraction of the increment.
  struct Point {
    double share;
    std::vector<PairState> states;
    Eigen::VectorXd motion;  // empty at the start
  };

  // Pairs that begin to slide, touch or part between two points.
  std::vector<std::size_t> events(const Point& a, const Point& b) const;
  bool evaluate(double share);  // sets point_
  void approach();
  double end_at(const Point& point);
  // Fraction at which the first event is expected, extrapolated from two points before it.
  double expected() const;

  Equilibrium& equilibrium_;
  const StaticConfiguration& from_;
  double time_, increment_;
  const std::function<bool()>& proceed_;
  Balance balance_;               // of the last evaluation
  Point before_, last_, beyond_;  // two before the event, one after it
  Point whole_;
  Point point_;  // evaluated last
};

}  // namespace scree::response
