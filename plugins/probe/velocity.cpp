// Mean velocities of parts of space, such as a profile v_x(z).

#include <scree/plugin/bin_motion.hpp>
#include <scree/plugin/space_bins.hpp>

namespace {

struct VelocityProbe {
  scree::SpaceBins bins;
  int dimension = 3;

  static constexpr scree::About about = {
      "velocity", "mean velocity and spin of the bodies in each bin at the time, by their centres",
      "x, y, z = Σ_i m_i v_i/Σ_i m_i,   spin_x, spin_y, spin_z = Σ_i ω_i/N, in 2D spin_z alone\n"
      "with several bins bodies_1, x_1, ...; NaN in a bin without bodies\n"
      "The probe profile follows the bodies that were in a bin at the start.",
      "—"};

  void declare(scree::Declaration& d) { bins.declare(d); }
  void prepare(const scree::Setup& setup) {
    bins.check(setup);
    dimension = setup.dimension();
  }
  void describe(scree_probe_instance& instance) const {
    instance.column_count = per_bin() * std::uint32_t(bins.bins);
    instance.leaves_out = 1;
    instance.total_count = bins.totals() + scree::BinMotion::width * std::uint32_t(bins.bins);
    instance.passes = bins.passes() + 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* spatial[] = {"bodies", "x", "y", "z", "spin_x", "spin_y", "spin_z"};
    static constexpr const char* planar[] = {"bodies", "x", "y", "spin_z"};
    const std::uint32_t k = c % per_bin(), translations = std::uint32_t(dimension);
    const char* const unit = k == 0 ? "" : k <= translations ? "m/s" : "rad/s";
    const char* const meaning = k == 0              ? "number of bodies whose centre lies in the bin"
                                : k <= translations ? "mean velocity along the axis, by mass"
                                                    : "mean spin about the axis";
    return {bins.numbered(dimension == 2 ? planar[k] : spatial[k], c / per_bin()), unit, meaning};
  }
  std::string start(const scree_view& view, double*) const { return bins.problem(view); }

  void accumulate(const scree_view& part, std::uint32_t pass, double* totals) const {
    if (bins.finds_followed(part, pass, totals)) return;
    scree::BinMotion::add(part, bins.frame(part), totals + bins.totals());
  }
  void sample(const scree_view& view, const double*, double* row) const {
    const scree::BinMotion motion(view.totals + bins.totals());
    for (int bin = 0; bin < bins.bins; ++bin) {
      const scree::BinMotion::Sums sums = motion[std::size_t(bin)];
      *row++ = sums.bodies;
      for (int k = 0; k < dimension; ++k) *row++ = sums.velocity()[k];
      for (int k = dimension == 2 ? 2 : 0; k < 3; ++k) *row++ = sums.mean_spin()[k];
    }
  }

 private:
  std::uint32_t per_bin() const { return dimension == 2 ? 4 : 7; }
};

}  // namespace

SCREE_PROBE_PLUGIN(VelocityProbe)
