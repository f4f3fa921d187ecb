// Granular temperatures of parts of space.

#include <vector>

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
  }
  scree::ColumnName column(std::uint32_t c) const {
    const std::uint32_t k = c % std::uint32_t(std::size(names));
    return {bins.numbered(names[k], c / std::uint32_t(std::size(names))), units[k], meanings[k]};
  }
  std::string start(const scree_view& view, double*) const { return bins.problem(view); }

  void sample(const scree_view& view, const double*, double* row) const {
    const scree::AveragingFrame frame = bins.frame(view);
    const scree::BinMotion motion(view, frame);
    std::vector<double> translation(motion.bins.size(), 0), rotation(motion.bins.size(), 0);
    motion.each_body(view,
                     [&](std::uint64_t i, std::size_t bin, const scree::Vec3& v, const scree::Vec3& spin) {
                       translation[bin] += view.mass[i] * dot(v, v);
                       if (view.inertia) rotation[bin] += view.inertia[i] * dot(spin, spin);
                     });
    for (std::size_t bin = 0; bin < motion.bins.size(); ++bin) {
      const double bodies = motion.bins[bin].bodies;
      *row++ = bodies;
      *row++ = translation[bin] / (dimension * bodies);
      *row++ = rotation[bin] / ((dimension == 2 ? 1 : 3) * bodies);
    }
  }

 private:
  static constexpr const char* names[] = {"bodies", "translational", "rotational"};
  static constexpr const char* units[] = {"", "J", "J"};
  static constexpr const char* meanings[] = {"number of bodies whose centre lies in the bin",
                                             "twice the kinetic energy about the mean per degree of freedom",
                                             "the same of spins"};
};

}  // namespace

SCREE_PROBE_PLUGIN(TemperatureProbe)
