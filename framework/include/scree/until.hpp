#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

// A condition on a number, for the end of a stage.
struct Condition {
  static constexpr std::size_t energies = std::numeric_limits<std::size_t>::max();

  std::string name;              // "kinetic_over_elastic", "stress.zz"
  std::string unit;              // of the number; empty: none
  std::size_t probe = energies;  // which has the number as a column; `energies`: kinetic over elastic energy
  std::size_t column = 0;
  std::optional<double> above, below;
  // Largest change within a time `over` (s), relative to the largest value there.
  std::optional<double> steady;
  double over = 0;

  // "above 1000 and steady within 0.01 over 0.1 s"
  std::string wanted() const;
};

// What ends a stage that has no duration.
struct Until {
  std::vector<Condition> conditions;
  bool any = false;               // one of them suffices; else all hold at the same time
  double at_least = 0;            // (s) before which they are not tested
  std::optional<double> at_most;  // (s)
  bool goes_on = false;           // the stage ends after at_most, too; else that is an error

  bool reads_energies() const;
  bool reads_columns() const;
  // "kinetic_over_elastic below 1e-06 and stress.zz above 1000"
  std::string text() const;
};

// Where conditions take columns of probes from.
class StageColumns {
 public:
  virtual ~StageColumns() = default;
  // Observes and samples what is due `steps` after the start of the stage, once at each step. Returns the
  // steps at which more is due.
  virtual std::uint64_t take(const Simulation& simulation, const std::string& stage, std::uint64_t steps) = 0;
  // The steps after `steps` at which more is due.
  virtual std::uint64_t next(const Simulation& simulation, const std::string& stage,
                             std::uint64_t steps) const = 0;
  // A number of the row that was taken last; absent if that probe was not due.
  virtual std::optional<double> value(std::size_t probe, std::size_t column) const = 0;
  // What it keeps, unless its owner saves that.
  virtual void transfer(const StateTransfer&) {}
};

// The values of one condition in a stage.
class ConditionValues {
 public:
  explicit ConditionValues(const Condition& condition) : condition_(&condition) {}

  void take(double time, double value);
  std::optional<double> latest() const { return latest_; }
  // Not before there is a value, and `steady` not before values of that time are known. NaN meets no
  // condition.
  bool met() const;
  // "stress.zz = 312 Pa, above 1000"
  std::string status() const;
  // "stress.zz is 312 Pa, not above 1000"
  std::string problem() const;
  void transfer(const StateTransfer& state);

 private:
  double change() const;

  const Condition* condition_;
  std::optional<double> latest_;
  std::deque<std::pair<double, double>> recent_;  // time (s) and value, if they are to be steady
};

// Kinetic energy of the bodies that bear load over elastic energy; infinite without elastic energy. A body
// with one contact, which may roll on for ever, counts by its velocity along the normal alone. A body without
// contacts does not count. If no body has two contacts, all count with their whole energy. Walls count.
double kinetic_over_elastic(const Simulation& simulation);

// Which few bodies hold nearly all of the kinetic energy and how they move, with a cure: "6 bodies hold 99.9
// % of the kinetic energy, by rolling: particles 3, 7, ...; add ..."; empty if it is spread over many.
struct Movers {
  std::string what, cure;
};
std::optional<Movers> movers(const Simulation& simulation);

}  // namespace scree
