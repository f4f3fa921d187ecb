// The stress tensor of parts of space.

#include <vector>

#include <scree/plugin/bin_motion.hpp>
#include <scree/plugin/contact_line.hpp>
#include <scree/plugin/space_bins.hpp>
#include <scree/plugin/tensor_columns.hpp>

namespace {

using scree::AveragingFrame;
using scree::BinMotion;
using scree::SymmetricTensor;
using scree::Vec3;

enum Kinetic : int { without, with, only };

struct StressProbe {
  scree::SpaceBins bins;
  int kinetic = without;
  scree::TensorColumns tensor{.unit = "Pa"};

  static constexpr scree::About about = {
      "stress", "Love-Weber stress, above 0 in compression, with or without its kinetic part",
      "σ = (1/V) Σ_c f_c ⊗ l_c w_c   f: force on a; l: from b, or from the wall, to a; w: part of l in the bin\n"
      "kinetic part: (1/V) Σ_i m_i (v_i − v) ⊗ (v_i − v), v: mean velocity of the bin, by mass\n"
      "columns xx, ..., p, q, principal values; with several bins xx_1, ...; symmetric part\n"
      "of chosen bodies (groups, leave_out): the parts of l from their centres to the contact",
      "Weber 1966; Bagi 1996"};

  void declare(scree::Declaration& d) {
    bins.declare(d);
    d.choice("kinetic", kinetic, "without|with|only", "whether the motion about the mean of a bin counts");
  }
  void prepare(const scree::Setup& setup) {
    bins.check(setup);
    tensor.dimension = setup.dimension();
  }
  void describe(scree_probe_instance& instance) const {
    instance.needs = kinetic == only ? 0 : SCREE_NEEDS_CONTACTS;
    instance.column_count = tensor.count() * std::uint32_t(bins.bins);
    instance.leaves_out = 1;
    instance.total_count =
        motion_at() + (kinetic == without ? 0 : BinMotion::width) * std::uint32_t(bins.bins);
    instance.passes = bins.passes() + (kinetic == without ? 1 : 2);
  }
  scree::ColumnName column(std::uint32_t c) const {
    scree::ColumnName name = tensor.name(c % tensor.count());
    name.name = bins.numbered(name.name.c_str(), c / tensor.count());
    return name;
  }
  std::string start(const scree_view& view, double*) const { return bins.problem(view); }

  void accumulate(const scree_view& part, std::uint32_t pass, double* totals) const {
    if (bins.finds_followed(part, pass, totals)) return;
    const AveragingFrame frame = bins.frame(part);
    std::vector<SymmetricTensor> stress(std::size_t(frame.bins));
    if (pass > bins.passes()) {
      add_motion(part, frame, stress);
    } else {
      if (kinetic != without) BinMotion::add(part, frame, totals + motion_at());
      if (kinetic != only) add_contacts(part, frame, stress);
    }
    for (std::size_t bin = 0; bin < stress.size(); ++bin)
      stress[bin].add_to(totals + bins.totals() + SymmetricTensor::count * bin);
  }
  void sample(const scree_view& view, const double*, double* row) const {
    const AveragingFrame frame = bins.frame(view);
    for (int bin = 0; bin < frame.bins; ++bin) {
      auto stress =
          SymmetricTensor::of(view.totals + bins.totals() + SymmetricTensor::count * std::uint32_t(bin));
      stress.scale(1 / frame.volume(bin));
      row = tensor.write(stress, row);
    }
  }

 private:
  // Totals: of the region, the tensor of each bin, and for the kinetic part the means of each bin.
  std::uint32_t motion_at() const {
    return bins.totals() + SymmetricTensor::count * std::uint32_t(bins.bins);
  }
  static void add_contacts(const scree_view& part, const AveragingFrame& frame,
                           std::vector<SymmetricTensor>& stress) {
    for (std::uint64_t c = 0; c < part.contact_count; ++c) {
      const scree::ContactLine line(part, c);
      line.each_part(part, [&](const Vec3& start, const Vec3& step) {
        frame.split_line(start, step, [&](int bin, double share) {
          stress[std::size_t(bin)].add(share, line.force, step);
        });
      });
    }
  }
  void add_motion(const scree_view& part, const AveragingFrame& frame,
                  std::vector<SymmetricTensor>& stress) const {
    BinMotion(part.totals + motion_at())
        .each_body(part, frame, [&](std::uint64_t i, std::size_t bin, const Vec3& v, const Vec3&) {
          stress[bin].add(part.mass[i], v, v);
        });
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(StressProbe)
