#include <algorithm>
#include <cmath>

#include <scree/contact_columns.hpp>

namespace scree {

ContactColumns::ContactColumns(std::size_t count, Partner partner)
    : size_(count), padded_((count + SCREE_LANES - 1) / SCREE_LANES * SCREE_LANES), partner_(partner) {
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

scree_contact_batch ContactColumns::batch(double step, double kick) {
  derive_inputs();
  scree_contact_batch contacts = {};
  contacts.struct_size = sizeof(contacts);
  contacts.count = std::uint32_t(padded_);
  contacts.step = step;
  contacts.kick = kick;
  const auto inputs =
      std::size_t(partner_ == Partner::surface ? SCREE_CONTACT_INPUT_COUNT : SCREE_NORMAL_CHANGE);
  for (std::size_t k = 0; k < inputs; ++k) contacts.input[k] = input_.data() + k * padded_;
  for (std::size_t k = 0; k < SCREE_MAX_HISTORY; ++k) contacts.history[k] = history_.data() + k * padded_;
  for (std::size_t k = 0; k < SCREE_CONTACT_OUTPUT_COUNT; ++k)
    contacts.output[k] = output_.data() + k * padded_;
  return contacts;
}

}  // namespace scree
