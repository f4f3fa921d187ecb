// A probe by somebody else: amplitude of the height of the first body at 1 Hz, by the lock-in of the plug-in
// headers.

#include <limits>
#include <span>
#include <vector>

#include <scree/error.hpp>
#include <scree/plugin/lock_in.hpp>
#include <scree/plugin/probe.hpp>

namespace {

struct HeightAmplitude {
  static constexpr scree::About about = {"height_amplitude", "amplitude of the height of the first body", "",
                                         ""};

  void declare(scree::Declaration&) {}
  void describe(scree_probe_instance& instance) const { instance.column_count = 1; }
  scree::ColumnName column(std::uint32_t) const { return {"height_amplitude", "m", "at 1 Hz"}; }

  static scree::LockInOptions options() { return {.frequency = 1, .duration = 10}; }
  std::uint64_t state_size(const scree_view&) const { return scree::LockIn::state_size(options()); }
  void observe(const scree_view& view, double* state) const {
    scree::LockIn(options(), {state, state_size(view)})
        .add(view.time, scree::unwrapped_position(view, 0).component[1]);
  }
  void sample(const scree_view& view, const double* state, double* row) const {
    std::vector<double> copy(state, state + state_size(view));
    try {
      row[0] = scree::LockIn(options(), copy).result().lines[0].amplitude;
    } catch (const scree::Error&) {
      row[0] = std::numeric_limits<double>::quiet_NaN();  // too few samples so far
    }
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(HeightAmplitude)
