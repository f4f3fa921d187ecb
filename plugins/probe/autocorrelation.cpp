// How long bodies keep their velocities and spins.

#include <algorithm>
#include <cmath>

#include <scree/plugin/probe.hpp>

namespace {

struct AutocorrelationProbe {
  static constexpr scree::About about = {
      "autocorrelation", "correlation of velocities and spins with those at the start of the probe",
      "velocity = Σ_i v_i(0)·v_i(t)/Σ_i |v_i(0)|²,   spin = Σ_i ω_i(0)·ω_i(t)/Σ_i |ω_i(0)|²\n"
      "0: the start of the first stage in which the probe records; NaN if all were at rest then",
      "—"};

  void declare(scree::Declaration&) {}
  void describe(scree_probe_instance& instance) const {
    instance.column_count = 2;
    instance.leaves_out = 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    return {c == 0 ? "velocity" : "spin", "", "1 at the start"};
  }
  // State: velocity and spin of each body at the start.
  std::uint64_t state_size(const scree_view& view) const { return 6 * view.body_count; }
  std::string start(const scree_view& view, double* state) const {
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      std::copy_n(scree::vector_of(view.velocity, i).component, 3, state + 6 * i);
      std::copy_n(scree::vector_of(view.spin, i).component, 3, state + 6 * i + 3);
    }
    return "";
  }
  void sample(const scree_view& view, const double* state, double* row) const {
    row[0] = correlation(view, view.velocity, state);
    row[1] = correlation(view, view.spin, state + 3);
  }

 private:
  static double correlation(const scree_view& view, const scree_column (&columns)[3], const double* state) {
    double product = 0, square = 0;
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      if (!scree::counts(view, i)) continue;
      const double* const start = state + 6 * i;
      const scree::Vec3 now = scree::vector_of(columns, i);
      for (int k = 0; k < 3; ++k) {
        product += start[k] * now[k];
        square += start[k] * start[k];
      }
    }
    return product / square;
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(AutocorrelationProbe)
