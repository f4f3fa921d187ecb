// A probe with memory: the mean kinetic energy since the start, updated at every step. Replace columns, state
// and formulas by your own; the guide is share/doc/scree/plugins.md of scree.

#include <scree/plugin/probe.hpp>

namespace {

struct PluginName {
  static constexpr scree::About about = {"plugin_name", "kinetic energy of translation, now and its mean",
                                         "E = Σ ½ m v²    mean: over all steps since the start",
                                         "your source, with the number of the equation"};

  void declare(scree::Declaration&) {}

  // The host keeps the state: here the sum of energies and their number.
  void describe(scree_probe_instance& instance) const {
    instance.column_count = 2;
    instance.state_width = 2;
  }
  scree::ColumnName column(std::uint32_t c) const { return {c == 0 ? "now" : "mean", "J"}; }

  // At every step, or every `observe_every` of the scenario.
  void observe(const scree_view& view, double* state) const {
    state[0] += energy(view);
    state[1] += 1;
  }
  // For every row of the CSV.
  void sample(const scree_view& view, const double* state, double* row) const {
    row[0] = energy(view);
    row[1] = state[0] / state[1];
  }

 private:
  static double energy(const scree_view& view) {
    double sum = 0;
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      const scree::Vec3 velocity = scree::vector_of(view.velocity, i);
      sum += 0.5 * view.mass[i] * dot(velocity, velocity);
    }
    return sum;
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(PluginName)
