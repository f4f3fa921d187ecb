// A probe of somebody else that reads two columns of other probes.

#include <scree/plugin/probe.hpp>

namespace {

struct Ratio {
  scree::InputColumn above, below;

  static constexpr scree::About about = {
      "ratio", "ratio of two columns, and the sum of the first over all steps", "above/below", "—"};

  void declare(scree::Declaration& d) {
    d.input("above", above, "numerator").required();
    d.input("below", below, "denominator").required();
  }
  void describe(scree_probe_instance& instance) const {
    instance.column_count = 2;
    instance.state_width = 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    return c == 0 ? scree::ColumnName{"ratio", ""} : scree::ColumnName{"sum", above.unit};
  }
  void observe(const scree_view& view, double* state) const { state[0] += above.value(view); }
  void sample(const scree_view& view, const double* state, double* row) const {
    row[0] = above.value(view) / below.value(view);
    row[1] = state[0];
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(Ratio)
