#pragma once

#include <scree/plugin/contact_loop.hpp>
#include <scree/plugin/dual.hpp>

// The derivative of a law, from the same `force` evaluated with dual numbers.

namespace scree::detail {

// A column and its tangent at one pair; tangents that are not given are 0.
inline Dual dual_at(const double* column, const double* tangent, std::uint32_t i) {
  return {column[i], tangent ? tangent[i] : 0};
}

// Pairs that do not touch have zero derivatives. The history is not changed.
template <class Parameters, class Kernel, int D>
void differentiate_contacts(const void* storage, const scree_contact_batch* batch,
                            const scree_contact_tangent* tangent) {
  using History = typename Kernel::template History<D, Dual>;
  const Kernel kernel{*static_cast<const Parameters*>(storage)};
  for (std::uint32_t i = 0; i < batch->count; ++i) {
    const auto read = [&](std::uint32_t k) { return dual_at(batch->input[k], tangent->input[k], i); };
    auto contact = load_contact<Kernel, D>(read, Dual(batch->step), Dual(batch->kick));
    if constexpr (follows_surfaces<Kernel>)
      if (batch->input[SCREE_NORMAL_CHANGE]) load_surface(read, contact);
    History history{};
    each_component<history_width<Kernel, D>, Dual>(
        history, [&](std::uint32_t k, Dual& value) { value = batch->history[k][i]; });
    LawOutput<D, Dual, Kernel::writes_couple> out{};
    kernel.force(contact, history, out);

    const auto write = [&](std::uint32_t column, const Dual& value) {
      tangent->output[column][i] = contact.overlap > 0 ? value.derivative : 0;
    };
    for (std::uint32_t k = 0; k < D; ++k) write(SCREE_FORCE + k, out.force[int(k)]);
    if constexpr (Kernel::writes_couple)
      for (std::uint32_t k = 0; k < spin_components<D>; ++k) write(SCREE_COUPLE + k, out.couple[int(k)]);
  }
}

}  // namespace scree::detail
