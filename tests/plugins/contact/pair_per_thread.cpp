// A contact law as a GPU would evaluate it, one pair per thread. SCREE_LAW: its source.

#include <scree/plugin/contact_law.hpp>

namespace scree::test {

template <class Kernel, int D, bool backwards, bool onset, bool at_surface>
[[gnu::flatten]] void evaluate_pair(const Kernel& kernel, const Contact<D, double, Kernel::reads>* contacts,
                                    typename Kernel::template History<D, double>* histories,
                                    LawOutput<D, double, Kernel::writes_couple>* outputs, double* released,
                                    unsigned count) {
  const unsigned i =
      __nvvm_read_ptx_sreg_ctaid_x() * __nvvm_read_ptx_sreg_ntid_x() + __nvvm_read_ptx_sreg_tid_x();
  if (i >= count) return;
  auto contact = contacts[i];
  contact.backwards = backwards;
  contact.onset = onset;
  contact.at_surface = at_surface;
  auto history = histories[i];
  released[i] = detail::released_energy(kernel, history);
  LawOutput<D, double, Kernel::writes_couple> out{};
  kernel.force(contact, history, out);
  histories[i] = history;
  outputs[i] = out;
}

// Addresses of functions, so that these are compiled.
template <class Kernel, int D, bool at_surface>
struct FunctionsAtPartner {
  static constexpr bool returns = detail::follows_backwards<Kernel>, begins = detail::follows_onset<Kernel>;
  decltype(&evaluate_pair<Kernel, D, false, false, at_surface>) forwards =
      &evaluate_pair<Kernel, D, false, false, at_surface>;
  decltype(forwards) backwards = &evaluate_pair<Kernel, D, returns, false, at_surface>;
  decltype(forwards) onset = &evaluate_pair<Kernel, D, false, begins, at_surface>;
};
template <class Kernel, int D>
struct FunctionsOfKernel {
  FunctionsAtPartner<Kernel, D, false> body;
  FunctionsAtPartner<Kernel, D, detail::follows_surfaces<Kernel>> surface;
};
template <class Kernel>
struct InAllDimensions {
  FunctionsOfKernel<Kernel, Kernel::only_dimension == 3 ? 3 : 2> lower;
  FunctionsOfKernel<Kernel, Kernel::only_dimension == 2 ? 2 : 3> higher;
};
template <class... Kernels>
struct FunctionsOfLaw : InAllDimensions<Kernels>... {};

}  // namespace scree::test

// Instead of registering the law.
#undef SCREE_CONTACT_LAW_PLUGIN
#define SCREE_CONTACT_LAW_PLUGIN(Parameters, ...) \
  [[gnu::used]] constinit scree::test::FunctionsOfLaw<__VA_ARGS__> functions_of_law;
#include SCREE_LAW
