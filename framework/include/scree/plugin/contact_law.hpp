#pragma once

#include <array>
#include <type_traits>

#include <scree/plugin/abi.h>
#include <scree/plugin/contact.hpp>
#include <scree/plugin/contact_derivative.hpp>
#include <scree/plugin/contact_loop.hpp>
#include <scree/plugin/declaration.hpp>

// How to write a contact law: plugins/README.md. The author's `force` is a pure, branch-free function of one
// contact; this header applies it to batches in a vectorised loop, and with dual numbers for its derivatives.
// Write selections as ?:, std::max, std::min.

namespace scree {

// Base of every law, with defaults; a kernel overrides what differs.
struct ContactLaw {
  static constexpr std::uint32_t reads = reads_overlap | reads_normal;
  static constexpr bool tangential = false;  // has tangential forces: bodies must carry spin
  static constexpr bool writes_couple = false;
  static constexpr scree_arms arms = SCREE_ARM_CONTACT_POINT;
  static constexpr int only_dimension = 0;  // 2: a law of discs, 3: of spheres, 0: of both
  // Forces multiplied by `onset_weight` begin as t^onset_power at first touch and end as t^parting_power at
  // parting: 0 (a jump), 1/4, 1/2 or 3/4; `continuous` where they need no weights.
  static constexpr double continuous = 1;
  double onset_power() const { return 0; }
  double parting_power() const { return 0; }
};

namespace detail {

// The host stores a history as columns of numbers in declared order.
template <class Kernel, int D>
constexpr void check_history() {
  using History = typename Kernel::template History<D, double>;
  using DualHistory = typename Kernel::template History<D, Dual>;
  constexpr std::uint32_t width = history_width<Kernel, D>;
  static_assert(std::is_trivially_copyable_v<History> && std::is_standard_layout_v<History> &&
                    (std::is_empty_v<History> || sizeof(DualHistory) == 2 * sizeof(History)),
                "a History<D, T> has only members of type T and Vec<N, T>");
  static_assert(width <= SCREE_MAX_HISTORY, "a history has at most SCREE_MAX_HISTORY numbers");
  if constexpr (requires { History::names; })
    static_assert(History::names.size() == width, "History::names has one name for each number");
  if constexpr (requires { History::sliding_column; })
    static_assert(0 <= History::sliding_column && std::uint32_t(History::sliding_column) < width,
                  "History::sliding_column is the index of a number of the history");
}

template <class Parameters, class Kernel, int D>
constexpr void check_kernel() {
  using History = typename Kernel::template History<D, double>;
  constexpr std::uint32_t needs_spin = reads_tangential_increment | reads_relative_spin | reads_orientations;
  static_assert(std::is_base_of_v<Parameters, Kernel> && sizeof(Kernel) == sizeof(Parameters),
                "a kernel derives from the struct of the parameters and has no data of its own");
  static_assert(Kernel::reads & reads_overlap, "`reads` contains reads_overlap");
  static_assert(Kernel::tangential || !(Kernel::writes_couple || (Kernel::reads & needs_spin)),
                "a kernel that reads spins, orientations or tangential increments, or writes couples, sets "
                "`tangential = true`, so that bodies carry spin");
  static_assert(
      requires(const Kernel& kernel, const Contact<D, double, Kernel::reads>& contact, History& history,
               LawOutput<D, double, Kernel::writes_couple>& out) { kernel.force(contact, history, out); },
      "a kernel has force(const Contact<D, T, reads>&, History<D, T>&, LawOutput<D, T, writes_couple>&) const");
  check_history<Kernel, D>();
}

template <class Parameters, class Kernel, int D>
scree_contact_instance describe_kernel(const Parameters& parameters) {
  check_kernel<Parameters, Kernel, D>();
  using History = typename Kernel::template History<D, double>;
  scree_contact_instance instance = {};
  instance.struct_size = sizeof(instance);
  instance.reads = Kernel::reads;
  instance.writes_couple = Kernel::writes_couple;
  instance.tangential = Kernel::tangential;
  instance.arms = Kernel::arms;
  instance.follows_surfaces = follows_surfaces<Kernel>;
  instance.history_width = history_width<Kernel, D>;
  instance.sliding_column = -1;
  if constexpr (requires { History::sliding_column; }) instance.sliding_column = History::sliding_column;
  instance.onset_power = parameters.onset_power();
  instance.parting_power = parameters.parting_power();
  if constexpr (requires { History::names; }) instance.history_names = History::names.data();
  instance.evaluate = &evaluate_contacts<Parameters, Kernel, D>;
  instance.differentiate = &differentiate_contacts<Parameters, Kernel, D>;
  return instance;
}

// Whether the kernel computes what the parameters demand; a law with one kernel need not say so.
template <class Parameters, class Kernel>
bool suits(const Parameters& parameters) {
  if constexpr (requires { Kernel::suits(parameters); })
    return Kernel::suits(parameters);
  else
    return true;
}

template <class Parameters, class... Kernels>
int configure_law(const scree_setup* setup, void* storage, scree_contact_instance* instance) {
  static_assert(sizeof...(Kernels) == 1 || (requires(const Parameters& p) { Kernels::suits(p); } && ...),
                "each of several kernels has static bool suits(const Parameters&)");
  if (const int failed = configure_author<Parameters>(setup, storage)) return failed;
  const Parameters& parameters = *static_cast<const Parameters*>(storage);
  const auto configured = [&]<int D>() {
    if constexpr (Parameters::only_dimension == 0 || Parameters::only_dimension == D)
      return ((suits<Parameters, Kernels>(parameters) &&
               (*instance = describe_kernel<Parameters, Kernels, D>(parameters), true)) ||
              ...);
    else
      return false;
  };
  const bool flat = setup->dimension == 2;
  if (flat ? configured.template operator()<2>() : configured.template operator()<3>()) return 0;
  Setup(*setup).refuse("no kernel of this law suits these parameters; change them, or add a kernel");
  return 1;
}

template <class Parameters>
constexpr std::uint32_t dimensions_of =
    Parameters::only_dimension == 0 ? 1u << 2 | 1u << 3 : 1u << Parameters::only_dimension;

template <class Parameters>
std::uint32_t closed_forms_of_law(const void* storage, const scree_encounter* encounter,
                                  scree_closed_form* forms, std::uint32_t capacity) {
  return static_cast<const Parameters*>(storage)->closed_forms(*encounter, forms, capacity);
}

}  // namespace detail

// Parameters: a ContactLaw with `about`, `declare`, `closed_forms`.
// Kernels: derived from Parameters without data of their own. Of several, the first whose
// `static bool suits(const Parameters&)` is true is used: list the cheapest first.
#define SCREE_CONTACT_LAW_PLUGIN(Parameters, ...)                                                           \
  static const scree_contact_law scree_interface = {sizeof(scree_contact_law), sizeof(Parameters),          \
                                                    scree::detail::dimensions_of<Parameters>,               \
                                                    &scree::detail::configure_law<Parameters, __VA_ARGS__>, \
                                                    &scree::detail::closed_forms_of_law<Parameters>};       \
  SCREE_EXPORT_PLUGIN((scree::manifest_of<Parameters>(SCREE_CONTACT_LAW, scree_interface)))

}  // namespace scree
