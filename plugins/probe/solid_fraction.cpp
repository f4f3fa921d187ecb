// Which part of space bodies fill.

#include <scree/plugin/space_bins.hpp>

namespace {

struct SolidFractionProbe {
  scree::SpaceBins bins;

  static constexpr scree::About about = {
      "solid_fraction", "volume of bodies over the volume of each bin, exact for spheres that bins cut",
      "solid_fraction = Σ_i V_i(bin)/V(bin)   V_i(bin): volume of sphere i in the bin, in 2D area of the disc\n"
      "overlaps of bodies count twice; of region = \"enclosed\" the bin at a wall has what reaches into the wall too\n"
      "with several bins solid_fraction_1, ..., volume_1, ...",
      "closed forms of spheres cut by planes and spheres; by cylinders, cones, and slices of spheres, integrals to 1e-13"};

  void declare(scree::Declaration& d) { bins.declare(d); }
  void prepare(const scree::Setup& setup) { bins.check(setup); }
  void describe(scree_probe_instance& instance) const {
    instance.column_count = 2 * std::uint32_t(bins.bins);
    instance.leaves_out = 1;
    instance.total_count = bins.totals() + std::uint32_t(bins.bins);
    instance.passes = bins.passes() + 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    if (c % 2 == 0)
      return {bins.numbered("solid_fraction", c / 2), "", "volume of bodies over the volume of the bin"};
    return {bins.numbered("volume", c / 2), "m^3", "of the bin; in 2D its area (m²)"};
  }
  std::string start(const scree_view& view, double*) const { return bins.problem(view); }

  void accumulate(const scree_view& part, std::uint32_t pass, double* totals) const {
    if (bins.finds_followed(part, pass, totals)) return;
    const scree::AveragingFrame frame = bins.frame(part);
    double* const filled = totals + bins.totals();
    for (std::uint64_t i = part.part_begin; i < part.part_end; ++i)
      if (scree::counts(part, i))
        frame.split_sphere(scree::vector_of(part.position, i), part.radius[i],
                           [&](int bin, double volume) { filled[bin] += volume; });
  }
  void sample(const scree_view& view, const double*, double* row) const {
    const scree::AveragingFrame frame = bins.frame(view);
    const double* const filled = view.totals + bins.totals();
    for (int bin = 0; bin < frame.bins; ++bin) {
      const double volume = frame.volume(bin);
      *row++ = filled[bin] / volume;
      *row++ = volume;
    }
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(SolidFractionProbe)
