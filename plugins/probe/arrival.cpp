// When a signal arrives.

#include <cmath>

#include <scree/plugin/input_column.hpp>
#include <scree/plugin/probe.hpp>

namespace {

struct ArrivalProbe {
  scree::InputColumn of;
  double threshold = 0;

  static constexpr scree::About about = {
      "arrival", "when a column of another probe has first changed by more than a threshold",
      "arrival: |x(t) − x(0)| = threshold, on the straight line between the observations before and after; NaN until then\n"
      "0: the start of the first stage in which the probe records; of two arrivals, speed = distance/difference",
      "—"};

  void declare(scree::Declaration& d) {
    d.input("of", of, "column whose change is watched, at every step or each observe_every").required();
    d.number("threshold", threshold, "", scree::positive,
             "change at which the signal has arrived, in its unit")
        .required();
  }
  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_NO_BODIES;
    instance.column_count = 2;
    instance.state_width = state_width;
  }
  scree::ColumnName column(std::uint32_t c) const {
    if (c == 0) return {"arrival", "s", "time of the arrival, from t = 0 of the run; NaN before"};
    return {"change", of.unit ? of.unit : "", "largest change so far, as an amount"};
  }
  void observe(const scree_view& view, double* state) const {
    const double value = of.value(view);
    if (state[begun] == 0) {
      state[begun] = 1;
      state[first] = value;
    }
    const double change = std::abs(value - state[first]);
    if (state[arrived] == 0 && change >= threshold) {
      const double before = state[change_before];
      const double part = change > before ? (threshold - before) / (change - before) : 1;
      state[arrived] = 1;
      state[arrival] = state[time_before] + part * (view.time - state[time_before]);
    }
    state[time_before] = view.time;
    state[change_before] = change;
    if (change > state[largest]) state[largest] = change;
  }
  void sample(const scree_view&, const double* state, double* row) const {
    row[0] = state[arrived] != 0 ? state[arrival] : std::nan("");
    row[1] = state[largest];
  }

 private:
  enum : std::uint32_t { begun, first, time_before, change_before, largest, arrived, arrival, state_width };
};

}  // namespace

SCREE_PROBE_PLUGIN(ArrivalProbe)
