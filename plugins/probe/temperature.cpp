// Granular temperatures of parts of space.

#include <scree/plugin/bin_motion.hpp>
#include <scree/plugin/space_bins.hpp>

namespace {

struct TemperatureProbe {
  scree::SpaceBins bins;
  int dimension = 3;

  static constexpr scree::About about = {
      "temperature", "granular temperature of translation and rotation, about the mean of each bin",
      "translational = Σ_i m_i |v_i − v|²/(D N),   rotational = Σ_i I_i |ω_i − ω|²/(S N),   S = 3, in 2D 1\n"
      "v: mean velocity of the bin by mass, ω: mean spin; bins along an axis give the temperature about the local mean\n"
      "NaN in a bin without bodies",
      "Goldhirsch 2003"};

  void declare(scree::Declaration& d) { bins.declare(d); }
  void prepare(const scree::Setup& setup) {
    bins.check(setup);
    dimension = setup.dimension();
  }
  void describe(scree_probe_instance& instance) const {
    instance.column_count = std::uint32_t(std::size(names)) * std::uint32_t(bins.bins);
    instance.leaves_out = 1;
    instance.total_count = motions_at() + of_motion * std::uint32_t(bins.bins);
    instance.passes = bins.passes() + 2;
  }
  scree::ColumnName column(std::uint32_t c) const {
    const std::uint32_t k = c % std::uint32_t(std::size(names));
    return {bins.numbered(names[k], c / std::uint32_t(std::size(names))), units[k], meanings[k]};
  }
  std::string start(const scree_view& view, double*) const { return bins.problem(view); }

  void accumulate(const scree_view& part, std::uint32_t pass, double* totals) const {
    if (bins.finds_followed(part, pass, totals)) return;
    const scree::AveragingFrame frame = bins.frame(part);
    if (pass == bins.passes()) return scree::BinMotion::add(part, frame, totals + bins.totals());
    double* const motions = totals + motions_at();
    scree::BinMotion(part.totals + bins.totals())
        .each_body(part, frame,
                   [&](std::uint64_t i, std::size_t bin, const scree::Vec3& v, const scree::Vec3& spin) {
                     motions[of_motion * bin] += part.mass[i] * dot(v, v);
                     if (part.inertia) motions[of_motion * bin + 1] += part.inertia[i] * dot(spin, spin);
                   });
  }
  void sample(const scree_view& view, const double*, double* row) const {
    const scree::BinMotion means(view.totals + bins.totals());
    const double* const motions = view.totals + motions_at();
    for (std::size_t bin = 0; bin < std::size_t(bins.bins); ++bin) {
      const double bodies = means[bin].bodies;
      *row++ = bodies;
      *row++ = motions[of_motion * bin] / (dimension * bodies);
      *row++ = motions[of_motion * bin + 1] / ((dimension == 2 ? 1 : 3) * bodies);
    }
  }

 private:
  // Totals of a bin behind the means: Σ m |v|², Σ I |ω|² about these.
  static constexpr std::uint32_t of_motion = 2;
  std::uint32_t motions_at() const {
    return bins.totals() + scree::BinMotion::width * std::uint32_t(bins.bins);
  }
  static constexpr const char* names[] = {"bodies", "translational", "rotational"};
  static constexpr const char* units[] = {"", "J", "J"};
  static constexpr const char* meanings[] = {"number of bodies whose centre lies in the bin",
                                             "twice the kinetic energy about the mean per degree of freedom",
                                             "the same of spins"};
};

}  // namespace

SCREE_PROBE_PLUGIN(TemperatureProbe)
