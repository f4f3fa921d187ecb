#include "probe_drafts.hpp"

#include <algorithm>

#include <scree/plugin/probe.hpp>

namespace scree::scenario {

namespace {

// Texts and formulas as numbers, which the parameters of a plug-in can hold.
struct DerivedProbe {
  scree_value texts = {};     // name and unit of each column, each ended by 0
  scree_value formulas = {};  // of each column: how many numbers encode it, and these

  static constexpr About about = {"derived", "quantities computed from columns of other probes", "—", "—"};

  void declare(Declaration& d) {
    d.list("texts", texts, "", any_number, "names and units").required();
    d.list("formulas", formulas, "", any_number, "encoded").required();
  }
  void describe(scree_probe_instance& instance) const { instance.column_count = columns(); }
  ColumnName column(std::uint32_t c) const { return {text(2 * c), text(2 * c + 1)}; }

  void sample(const scree_view& view, const double*, double* row) const {
    const std::size_t count = columns();
    std::vector<double> slots(count + 1 + view.input_count, view.time);
    std::copy_n(view.inputs, view.input_count, slots.end() - view.input_count);
    const double* at = formulas.data;
    for (std::size_t c = 0; c < count; ++c) {
      const auto size = std::size_t(*at++);
      row[c] = slots[c] = formula::value(formula::decoded({at, size}), slots);
      at += size;
    }
  }

 private:
  std::uint32_t columns() const {
    return std::uint32_t(std::count(texts.data, texts.data + texts.count, 0.0)) / 2;
  }
  std::string text(std::uint32_t number) const {
    const double* at = texts.data;
    for (; number > 0; ++at) number -= *at == 0;
    std::string text;
    for (; *at != 0; ++at) text += char(*at);
    return text;
  }
};

}  // namespace

const scree_plugin& derived_plugin() {
  return *manifest_of<DerivedProbe>(SCREE_PROBE, probe_interface<DerivedProbe>);
}

void set_quantities(const std::vector<DerivedQuantity>& quantities, Parameters& parameters) {
  std::vector<double> texts, formulas;
  for (const DerivedQuantity& quantity : quantities) {
    for (const std::string& text : {quantity.name, quantity.unit}) {
      texts.insert(texts.end(), text.begin(), text.end());
      texts.push_back(0);
    }
    const std::vector<double> numbers = formula::encoded(quantity.formula, quantity.slots);
    formulas.push_back(double(numbers.size()));
    formulas.insert(formulas.end(), numbers.begin(), numbers.end());
  }
  parameters.set("texts", texts);
  parameters.set("formulas", formulas);
}

}  // namespace scree::scenario
