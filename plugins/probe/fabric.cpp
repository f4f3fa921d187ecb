// How the normals of contacts are distributed over directions.

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
    instance.total_count = bins.totals() + per_bin * std::uint32_t(bins.bins);
    instance.passes = bins.passes() + 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    const std::uint32_t bin = c / (tensor.count() + 1), k = c % (tensor.count() + 1);
    scree::ColumnName name =
        k == 0 ? scree::ColumnName{"contacts", "", "number of contacts"} : tensor.name(k - 1);
    name.name = bins.numbered(name.name.c_str(), bin);
    return name;
  }
  std::string start(const scree_view& view, double*) const { return bins.problem(view); }

  void accumulate(const scree_view& part, std::uint32_t pass, double* totals) const {
    if (bins.finds_followed(part, pass, totals)) return;
    const scree::AveragingFrame frame = bins.frame(part);
    for (std::uint64_t c = 0; c < part.contact_count; ++c) {
      if (!scree::counts_contact(part, c) || (!walls && part.contact_b[c] >= part.body_count)) continue;
      const scree::ContactLine line(part, c);
      const int bin = frame.bin_of(line.point());
      if (bin < 0) continue;
      double* const of_bin = totals + bins.totals() + per_bin * std::uint32_t(bin);
      scree::SymmetricTensor product;
      product.add(1, line.normal, line.normal);
      of_bin[0] += 1;
      product.add_to(of_bin + 1);
    }
  }
  void sample(const scree_view& view, const double*, double* row) const {
    for (int bin = 0; bin < bins.bins; ++bin) {
      const double* const of_bin = view.totals + bins.totals() + per_bin * std::uint32_t(bin);
      auto fabric = scree::SymmetricTensor::of(of_bin + 1);
      fabric.scale(1 / of_bin[0]);
      *row++ = of_bin[0];
      row = tensor.write(fabric, row);
    }
  }

 private:
  // Totals of a bin: number of contacts, sum of products.
  static constexpr std::uint32_t per_bin = 1 + scree::SymmetricTensor::count;
};

}  // namespace

SCREE_PROBE_PLUGIN(FabricProbe)
