#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include <scree/plugin/abi.h>
#include <scree/plugin/contact_batch.hpp>
#include <scree/plugin/declaration.hpp>
#include <scree/plugin/roots.hpp>
#include <scree/plugin/vec.hpp>

// How to write a contact law: plugins/README.md. The author's `force` is a pure, branch-free function of one
// contact; this header applies it to batches in a vectorised loop. Write selections as ?:, std::max,
// std::min.

namespace scree {

// Input of a law: one touching pair. Members that the kernel's `reads` does not list are 0.
template <int D, class T = double>
struct Contact {
  Vec<D, T> normal;                          // unit, from b to a
  T overlap;                                 // (m) > 0
  Vec<D, T> relative_velocity;               // (m/s) of the contact points, a minus b, at the end of the step
  Vec<D, T> tangential_increment;            // (m) displacement of a's contact point relative to b's while
                                             // touching in this step, perpendicular to the mid-step normal
  Vec<spin_components<D>, T> relative_spin;  // (rad/s) a minus b
  T onset_weight;                            // factor for forces that begin as t^onset_power at first touch
  Root<T> contact_radius;                    // (m) a = √(R* δ) of a Hertzian contact, and 1/a
  T contact_radius_root;                     // (m^½) √a
  T reduced_mass, reduced_mass_root;         // (kg), (kg^½)
  T effective_radius;                        // (m)
  T step;                                    // (s) negative in a substep backwards in time
};

// Lower bound for divisors that may vanish; its reciprocal is finite.
template <class T>
inline constexpr T smallest_divisor = T(1e-300);
template <>
inline constexpr float smallest_divisor<float> = 1e-36f;

// Output of a law. All members are initialised to 0.
template <int D, class T = double>
struct Response {
  Vec<D, T> force;                    // (N) on a, the opposite on b
  Vec<spin_components<D>, T> couple;  // (N m) on a in addition to arm × force, the opposite on b
  T elastic_normal;                   // (J) stored
  T elastic_tangential;               // (J) stored
  T dissipated_normal;                // (W)
  T dissipated_tangential;            // (W)
  T dissipated_rolling;               // (W)
  T dissipated_friction;              // (J) during the step
  T dissipated_release;               // (J) during the step
};

// History of a law without memory.
template <int D, class T>
struct NoHistory {};

// Bits of `reads`, for the members of Contact.
inline constexpr std::uint32_t reads_normal = 1u << SCREE_NORMAL;
inline constexpr std::uint32_t reads_overlap = 1u << SCREE_OVERLAP;
inline constexpr std::uint32_t reads_relative_velocity = 1u << SCREE_RELATIVE_VELOCITY;
inline constexpr std::uint32_t reads_tangential_increment = 1u << SCREE_TANGENTIAL_INCREMENT;
inline constexpr std::uint32_t reads_relative_spin = 1u << SCREE_RELATIVE_SPIN;
inline constexpr std::uint32_t reads_onset_weight = 1u << SCREE_ONSET_WEIGHT;
inline constexpr std::uint32_t reads_contact_radius = 1u << SCREE_CONTACT_RADIUS;
inline constexpr std::uint32_t reads_reduced_mass = 1u << SCREE_REDUCED_MASS;
inline constexpr std::uint32_t reads_reduced_mass_root = 1u << SCREE_REDUCED_MASS_ROOT;
inline constexpr std::uint32_t reads_effective_radius = 1u << SCREE_EFFECTIVE_RADIUS;

// Base of every law, with defaults; a kernel overrides what differs.
struct ContactLaw {
  static constexpr std::uint32_t reads = reads_overlap | reads_normal;
  static constexpr bool tangential = false;  // has tangential forces: bodies must carry spin
  static constexpr bool writes_couple = false;
  static constexpr scree_arms arms = SCREE_ARM_CONTACT_POINT;
  // Forces multiplied by `onset_weight` begin as t^onset_power at first touch and end as t^parting_power at
  // parting: 0 (a jump), 1/4, 1/2 or 3/4; `continuous` where they need no weights.
  static constexpr double continuous = 1;
  double onset_power() const { return 0; }
  double parting_power() const { return 0; }
};

namespace detail {

template <int N, class T>
inline void load(Vec<N, T>& vector, const T* const* columns, std::uint32_t i) {
  for (int k = 0; k < N; ++k) vector[k] = columns[k][i];
}

template <class Kernel, int D, class T>
inline Contact<D, T> load_contact(const ContactBatch<T>& batch, std::uint32_t i) {
  Contact<D, T> c{};
  const T* const* in = batch.input;
  if constexpr (Kernel::reads & reads_normal) load(c.normal, in + SCREE_NORMAL, i);
  c.overlap = in[SCREE_OVERLAP][i];
  c.step = T(batch.step);
  if constexpr (Kernel::reads & reads_relative_velocity)
    load(c.relative_velocity, in + SCREE_RELATIVE_VELOCITY, i);
  if constexpr (Kernel::reads & reads_tangential_increment)
    load(c.tangential_increment, in + SCREE_TANGENTIAL_INCREMENT, i);
  if constexpr (Kernel::reads & reads_relative_spin) load(c.relative_spin, in + SCREE_RELATIVE_SPIN, i);
  if constexpr (Kernel::reads & reads_onset_weight) c.onset_weight = in[SCREE_ONSET_WEIGHT][i];
  if constexpr (Kernel::reads & reads_contact_radius) {
    c.contact_radius = {in[SCREE_CONTACT_RADIUS][i], in[SCREE_CONTACT_RADIUS + 1][i]};
    c.contact_radius_root = in[SCREE_CONTACT_RADIUS + 2][i];
  }
  if constexpr (Kernel::reads & reads_reduced_mass) c.reduced_mass = in[SCREE_REDUCED_MASS][i];
  if constexpr (Kernel::reads & reads_reduced_mass_root) c.reduced_mass_root = in[SCREE_REDUCED_MASS_ROOT][i];
  if constexpr (Kernel::reads & reads_effective_radius) c.effective_radius = in[SCREE_EFFECTIVE_RADIUS][i];
  return c;
}

// Number of values in a history struct, which are stored in declared order.
template <class Kernel, int D>
inline constexpr std::uint32_t history_width = std::is_empty_v<typename Kernel::template History<D, double>>
                                                   ? 0
                                                   : sizeof(typename Kernel::template History<D, double>) /
                                                         sizeof(double);

// Calls visit(k, component) for the `width` values of a history struct.
template <std::uint32_t width, class T, class History, class Visit>
inline void each_component(History& history, Visit visit) {
  T* components = reinterpret_cast<T*>(&history);
  [&]<std::size_t... k>(std::index_sequence<k...>) { (visit(std::uint32_t(k), components[k]), ...); }
  (std::make_index_sequence<width>{});
}

// Energy released when a contact opens with stretched springs (J).
template <class T, class Kernel, class History>
inline T released_energy(const Kernel& kernel, const History& history) {
  if constexpr (requires { kernel.stored_energy(history); })
    return kernel.stored_energy(history);
  else
    return T(0);
}

// Keeps values where a condition holds and sets them to 0 elsewhere. Uses bit masks, because compilers turn
// selections into branches and second stores.
template <class T>
class KeepIf {
 public:
  explicit KeepIf(bool condition)
      : mask_(std::bit_cast<Bits>(condition ? std::bit_cast<T>(Bits(~Bits(0))) : T(0))) {}
  T operator()(const T& value) const { return std::bit_cast<T>(std::bit_cast<Bits>(value) & mask_); }

 private:
  using Bits = std::conditional_t<sizeof(T) == sizeof(double), std::uint64_t, std::uint32_t>;
  Bits mask_;
};

// Flattened, because the loop vectorises only when the author's functions are inlined completely; not inlined
// itself, so that a test can find it in the machine code.
template <class Parameters, class Kernel, int D, bool audit, class T>
[[gnu::flatten, gnu::noinline]] void evaluate_batch(const Parameters& parameters,
                                                    const ContactBatch<T>& shared) {
  using History = typename Kernel::template History<D, T>;
  constexpr std::uint32_t width = history_width<Kernel, D>;
  // Local copies: the compiler need not assume that writing a column changes them.
  const Kernel kernel{parameters};
  const ContactBatch<T> batch = shared;
  const std::uint32_t count = batch.count & ~(SCREE_LANES - 1);
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const Contact<D, T> contact = load_contact<Kernel, D, T>(batch, i);
    History history{};
    each_component<width, T>(history, [&](std::uint32_t k, T& value) { value = batch.history[k][i]; });
    const T released = audit ? released_energy<T>(kernel, history) : T(0);

    Response<D, T> response{};
    kernel.force(contact, history, response);

    const bool touching = contact.overlap > T(0);
    const KeepIf<T> keep(touching);
    each_component<width, T>(history, [&](std::uint32_t k, T& value) { batch.history[k][i] = keep(value); });
    for (int k = 0; k < D; ++k) batch.output[SCREE_FORCE + k][i] = keep(response.force[k]);
    if constexpr (Kernel::writes_couple)
      for (int k = 0; k < spin_components<D>; ++k)
        batch.output[SCREE_COUPLE + k][i] = keep(response.couple[k]);
    if constexpr (audit) {
      batch.output[SCREE_ELASTIC_NORMAL][i] = keep(response.elastic_normal);
      batch.output[SCREE_ELASTIC_TANGENTIAL][i] = keep(response.elastic_tangential);
      batch.output[SCREE_DISSIPATED_NORMAL][i] = keep(response.dissipated_normal);
      batch.output[SCREE_DISSIPATED_TANGENTIAL][i] = keep(response.dissipated_tangential);
      batch.output[SCREE_DISSIPATED_ROLLING][i] = keep(response.dissipated_rolling);
      batch.output[SCREE_DISSIPATED_FRICTION][i] = keep(response.dissipated_friction);
      batch.output[SCREE_DISSIPATED_RELEASE][i] = touching ? response.dissipated_release : released;
    }
  }
}

template <class Parameters, class Kernel, int D, class T>
void evaluate_contacts(const void* storage, const ContactBatch<T>* batch) {
  const Parameters& parameters = *static_cast<const Parameters*>(storage);
  if (batch->output[SCREE_ELASTIC_NORMAL])
    evaluate_batch<Parameters, Kernel, D, true, T>(parameters, *batch);
  else
    evaluate_batch<Parameters, Kernel, D, false, T>(parameters, *batch);
}

template <class Parameters, class Kernel, int D>
scree_contact_instance describe_kernel(const Parameters& parameters) {
  using History = typename Kernel::template History<D, double>;
  scree_contact_instance instance = {};
  instance.struct_size = sizeof(instance);
  instance.reads = Kernel::reads | reads_overlap;
  instance.writes_couple = Kernel::writes_couple;
  instance.tangential = Kernel::tangential;
  instance.arms = Kernel::arms;
  instance.history_width = history_width<Kernel, D>;
  instance.sliding_column = -1;
  if constexpr (requires { History::sliding_column; }) instance.sliding_column = History::sliding_column;
  instance.onset_power = parameters.onset_power();
  instance.parting_power = parameters.parting_power();
  if constexpr (requires { History::names; }) instance.history_names = History::names.data();
  instance.evaluate = &evaluate_contacts<Parameters, Kernel, D, double>;
  instance.evaluate_single = &evaluate_contacts<Parameters, Kernel, D, float>;
  return instance;
}

template <class Parameters, class... Kernels>
int configure_law(const scree_setup* setup, void* storage, scree_contact_instance* instance) {
  if (const int failed = configure_author<Parameters>(setup, storage)) return failed;
  const Parameters& parameters = *static_cast<const Parameters*>(storage);
  const std::size_t choice = parameters.kernel();
  const bool plane = setup->dimension == 2;
  std::size_t k = 0;
  ((k++ == choice ? void(*instance = plane ? describe_kernel<Parameters, Kernels, 2>(parameters)
                                           : describe_kernel<Parameters, Kernels, 3>(parameters))
                  : void()),
   ...);
  return 0;
}

template <class Parameters>
std::uint32_t closed_forms_of_law(const void* storage, const scree_encounter* encounter,
                                  scree_closed_form* forms, std::uint32_t capacity) {
  return static_cast<const Parameters*>(storage)->closed_forms(*encounter, forms, capacity);
}

}  // namespace detail

// Parameters: a ContactLaw with `about`, `declare`, `kernel() -> index of the kernel to use`, `closed_forms`.
// Kernels: derived from Parameters without data of their own, cheapest first; `kernel` selects the cheapest
// one that the parameters allow.
#define SCREE_CONTACT_LAW_PLUGIN(Parameters, ...)                                                           \
  static const scree_contact_law scree_interface = {sizeof(scree_contact_law), sizeof(Parameters),          \
                                                    &scree::detail::configure_law<Parameters, __VA_ARGS__>, \
                                                    &scree::detail::closed_forms_of_law<Parameters>};       \
  SCREE_EXPORT_PLUGIN((scree::manifest_of<Parameters>(SCREE_CONTACT_LAW, scree_interface)))

}  // namespace scree
