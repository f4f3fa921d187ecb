#pragma once

#include "equilibrium/equilibrium.hpp"

namespace scree::response {

// Finds the first event within an increment during which contacts slide: another begins to slide, touches or parts.
//
// There slip may end or turn. A law sees an increment as a whole: slip that ends or turns within it leaves a spring that is wrong in proportion
// to the increment. So the increment is to end at the event.
class FirstEvent {
 public:
  // Of an increment (s) from a time (s) and a configuration, at whose end `whole` is the balance that was found last.
  FirstEvent(Equilibrium& equilibrium, const StaticConfiguration& from, double time, double increment,
             Balance whole, const std::function<bool()>& proceed);

  // Share of the increment up to the event; 1 if there is none or a balance on the way is not found, 0 if that at the end is not
  // found again. The last evaluation of the equilibrium is then that of the balance there.
  double find();
  Balance take_balance() { return std::move(balance_); }

 private:
  // A balance within the increment, or at its ends.
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
  // Share at which the first event is to be expected from two points before it.
  double expected() const;

  Equilibrium& equilibrium_;
  const StaticConfiguration& from_;
  double time_, increment_;
  const std::function<bool()>& proceed_;
  Balance balance_;               // of the last evaluation
  Point before_, last_, beyond_;  // two before the event, one behind it
  Point whole_;
  Point point_;  // evaluated last
};

}  // namespace scree::response
