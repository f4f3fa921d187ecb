// A probe with memory: the mean squared displacement of all bodies over windows of time. Replace columns,
// state and formulas by your own; the guide is share/doc/scree/plugins/README.md of scree.

#include <algorithm>

#include <scree/plugin/probe.hpp>

namespace {

struct PluginName {
  double window = 1;

  static constexpr scree::About about = {"plugin_name", "mean squared displacement over windows of time",
                                         "⟨|x(t) − x(t_0)|²⟩    x: path without jumps at periodic faces",
                                         "your source, with the number of the equation"};

  void declare(scree::Declaration& d) { d.number("window", window, "s", scree::positive, "t − t_0"); }
  void describe(scree_probe_instance& instance) const { instance.column_count = 1; }
  // Name, unit and meaning, which scree describe shows.
  scree::ColumnName column(std::uint32_t) const {
    return {"mean_squared_displacement", "m^2", "over all bodies and windows"};
  }

  // The host keeps the state: t_0, number of windows, sum over them; position of each body at t_0.
  std::uint64_t state_size(const scree_view& view) const { return 3 + 3 * view.body_count; }

  std::string start(const scree_view& view, double* state) const {
    if (view.body_count == 0) return "there are no bodies to follow; add some";
    state[0] = view.time;
    for (std::uint64_t i = 0; i < view.body_count; ++i)
      std::copy_n(scree::unwrapped_position(view, i).component, 3, state + 3 + 3 * i);
    return "";
  }

  // At every step, or every `observe_every` of the scenario.
  void observe(const scree_view& view, double* state) const {
    if (view.time - state[0] < window - 0.5 * view.step_length) return;
    double sum = 0;
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      const double* const first = state + 3 + 3 * i;
      const scree::Vec3 from = {{first[0], first[1], first[2]}};
      const scree::Vec3 moved = scree::unwrapped_position(view, i) - from;
      sum += dot(moved, moved) / double(view.body_count);
    }
    state[1] += 1, state[2] += sum;
    start(view, state);
  }

  // For every row of the CSV; NaN before the first window.
  void sample(const scree_view&, const double* state, double* row) const { row[0] = state[2] / state[1]; }
};

}  // namespace

SCREE_PROBE_PLUGIN(PluginName)
