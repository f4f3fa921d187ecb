// How the normals of contacts are distributed over directions.

#include <vector>

#include <scree/plugin/contact_line.hpp>
#include <scree/plugin/space_bins.hpp>
#include <scree/plugin/tensor_columns.hpp>

namespace {

struct FabricProbe {
  scree::SpaceBins bins;
  bool walls = false;
  scree::TensorColumns tensor{.unit = ""};

  static constexpr scree::About about = {
      "fabric", "fabric tensor: mean of the products of the components of contact normals",
      "F = (1/C) Σ_c n_c ⊗ n_c, over contacts whose point lies in the bin; trace F = 1\n"
      "columns contacts, xx, ..., p = 1/D, q: anisotropy, principal values; with several bins contacts_1, ...\n"
      "NaN without contacts",
      "Satake 1982; Oda 1982"};

  void declare(scree::Declaration& d) {
    bins.declare(d);
    d.boolean("walls", walls, "contacts with walls count too");
  }
  void prepare(const scree::Setup& setup) {
    bins.check(setup);
    tensor.dimension = setup.dimension();
  }
  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_CONTACTS;
    instance.column_count = (tensor.count() + 1) * std::uint32_t(bins.bins);
    instance.leaves_out = 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    const std::uint32_t bin = c / (tensor.count() + 1), k = c % (tensor.count() + 1);
    scree::ColumnName name =
        k == 0 ? scree::ColumnName{"contacts", "", "number of contacts"} : tensor.name(k - 1);
    name.name = bins.numbered(name.name.c_str(), bin);
    return name;
  }
  std::string start(const scree_view& view, double*) const { return bins.problem(view); }

  void sample(const scree_view& view, const double*, double* row) const {
    const scree::AveragingFrame frame = bins.frame(view);
    std::vector<scree::SymmetricTensor> fabric(std::size_t(frame.bins));
    std::vector<double> contacts(fabric.size(), 0);
    for (std::uint64_t c = 0; c < view.contact_count; ++c) {
      if (!scree::counts_contact(view, c) || (!walls && view.contact_b[c] >= view.body_count)) continue;
      const scree::ContactLine line(view, c);
      const int bin = frame.bin_of(line.point());
      if (bin < 0) continue;
      contacts[std::size_t(bin)] += 1;
      fabric[std::size_t(bin)].add(1, line.normal, line.normal);
    }
    for (std::size_t bin = 0; bin < fabric.size(); ++bin) {
      fabric[bin].scale(1 / contacts[bin]);
      *row++ = contacts[bin];
      row = tensor.write(fabric[bin], row);
    }
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(FabricProbe)
