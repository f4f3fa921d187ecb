#include <limits>
#include <stdexcept>

#include <scree/plugin/probe.hpp>

namespace {

// Counts bodies, and fails at the body of an id: throws, or gives NaN as the largest id.
struct FailingProbe {
  double id = 0;
  bool throws = true;

  static constexpr scree::About about = {"failing", "fails at a body", "", ""};
  void declare(scree::Declaration& d) {
    d.number("id", id, "", scree::any_number, "of the body");
    d.boolean("throws", throws, "an exception; else a number that is none");
  }
  void describe(scree_probe_instance& instance) const {
    instance.column_count = instance.total_count = 2;
    instance.largest_count = 1;
    instance.leaves_out = 1;
  }
  scree::ColumnName column(std::uint32_t c) const { return {c == 0 ? "bodies" : "largest_id", ""}; }
  void accumulate(const scree_view& part, std::uint32_t, double* totals) const {
    for (std::uint64_t i = part.part_begin; i < part.part_end; ++i) {
      if (!scree::counts(part, i)) continue;
      const bool failed = double(part.id[i]) == id;
      if (failed && throws) throw std::runtime_error("boo");
      totals[0] += 1;
      if (totals[1] < double(part.id[i])) totals[1] = double(part.id[i]);
      if (failed) totals[1] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  void sample(const scree_view& view, const double*, double* row) const {
    row[0] = view.totals[0];
    row[1] = view.totals[1];
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(FailingProbe)
