#include <algorithm>
#include <cmath>

#include <scree/contact_columns.hpp>

namespace scree {

ContactColumns::ContactColumns(std::size_t count)
    : size_(count), padded_((count + SCREE_LANES - 1) / SCREE_LANES * SCREE_LANES) {
  input_.assign(SCREE_CONTACT_INPUT_COUNT * padded_, 0.0);
  history_.assign(SCREE_MAX_HISTORY * padded_, 0.0);
  output_.assign(SCREE_CONTACT_OUTPUT_COUNT * padded_, 0.0);
  for (const scree_contact_input column :
       {SCREE_NORMAL, SCREE_ONSET_WEIGHT, SCREE_REDUCED_MASS, SCREE_EFFECTIVE_RADIUS})
    std::fill_n(input_.begin() + std::ptrdiff_t(std::size_t(column) * padded_), padded_, 1.0);
}

void ContactColumns::derive_inputs() {
  for (std::size_t i = 0; i < padded_; ++i) {
    input(SCREE_REDUCED_MASS_ROOT, 0, i) = std::sqrt(input(SCREE_REDUCED_MASS, 0, i));
    const double square = input(SCREE_EFFECTIVE_RADIUS, 0, i) * std::max(input(SCREE_OVERLAP, 0, i), 0.0);
    const double radius = std::sqrt(square);
    input(SCREE_CONTACT_RADIUS, 0, i) = radius;
    input(SCREE_CONTACT_RADIUS, 1, i) = radius > 0 ? 1 / radius : 0;
    input(SCREE_CONTACT_RADIUS, 2, i) = std::sqrt(radius);
  }
}

namespace {

// A batch of `count` contacts whose columns lie one after the other.
template <class Batch, class T>
Batch batch_of(double step, double kick, std::size_t count, const T* input, T* history, T* output) {
  Batch contacts = {};
  contacts.struct_size = sizeof(contacts);
  contacts.count = std::uint32_t(count);
  contacts.step = step;
  contacts.kick = kick;
  for (std::size_t k = 0; k < SCREE_CONTACT_INPUT_COUNT; ++k) contacts.input[k] = input + k * count;
  for (std::size_t k = 0; k < SCREE_MAX_HISTORY; ++k) contacts.history[k] = history + k * count;
  for (std::size_t k = 0; k < SCREE_CONTACT_OUTPUT_COUNT; ++k) contacts.output[k] = output + k * count;
  return contacts;
}

}  // namespace

scree_contact_batch ContactColumns::batch(double step, double kick) {
  derive_inputs();
  return batch_of<scree_contact_batch>(step, kick, padded_, input_.data(), history_.data(), output_.data());
}

void ContactColumns::evaluate_single(const ConfiguredLaw& law, double step, double kick) {
  if (!law.instance().evaluate_single) return;
  derive_inputs();
  const Column<float> input(input_.begin(), input_.end());
  Column<float> history(history_.begin(), history_.end()), output(output_.size(), 0.0f);
  const auto contacts =
      batch_of<scree_contact_batch_single>(step, kick, padded_, input.data(), history.data(), output.data());
  law.instance().evaluate_single(law.storage(), &contacts);
  std::copy(history.begin(), history.end(), history_.begin());
  std::copy(output.begin(), output.end(), output_.begin());
}

}  // namespace scree
