#pragma once

#include <bit>
#include <utility>

#include <scree/plugin/contact.hpp>

// The vectorised loop that applies a law's `force` to a batch of pairs.

namespace scree::detail {

template <int N, class T, class Read>
inline void load(Vec<N, T>& vector, const Read& read, std::uint32_t column) {
  for (int k = 0; k < N; ++k) vector[k] = read(column + std::uint32_t(k));
}

// read(column) returns the pair's value in an input column.
template <class Kernel, int D, class Read, class T>
inline Contact<D, T, Kernel::reads> load_contact(const Read& read, const T& step, const T& kick) {
  constexpr std::uint32_t reads = Kernel::reads;
  Contact<D, T, reads> c{};
  c.overlap = read(SCREE_OVERLAP);
  c.step = step;
  c.kick = kick;
  if constexpr (reads & reads_normal) load(c.normal, read, SCREE_NORMAL);
  if constexpr (reads & reads_relative_velocity) load(c.relative_velocity, read, SCREE_RELATIVE_VELOCITY);
  if constexpr (reads & reads_tangential_increment)
    load(c.tangential_increment, read, SCREE_TANGENTIAL_INCREMENT);
  if constexpr (reads & reads_relative_spin) load(c.relative_spin, read, SCREE_RELATIVE_SPIN);
  if constexpr (reads & reads_onset_weight) c.onset_weight = read(SCREE_ONSET_WEIGHT);
  if constexpr (reads & reads_contact_radius) {
    c.contact_radius = {read(SCREE_CONTACT_RADIUS), read(SCREE_CONTACT_RADIUS + 1)};
    c.contact_radius_root = read(SCREE_CONTACT_RADIUS + 2);
  }
  if constexpr (reads & reads_reduced_mass) c.reduced_mass = read(SCREE_REDUCED_MASS);
  if constexpr (reads & reads_reduced_mass_root) c.reduced_mass_root = read(SCREE_REDUCED_MASS_ROOT);
  if constexpr (reads & reads_effective_radius) c.effective_radius = read(SCREE_EFFECTIVE_RADIUS);
  if constexpr (reads & (1u << SCREE_ORIENTATION_A)) load(c.orientation_a, read, SCREE_ORIENTATION_A);
  if constexpr (reads & (1u << SCREE_ORIENTATION_B)) load(c.orientation_b, read, SCREE_ORIENTATION_B);
  if constexpr (reads & reads_separation) load(c.separation, read, SCREE_SEPARATION);
  if constexpr (reads & reads_radii) {
    c.radius_a = read(SCREE_RADII);
    c.radius_b = read(SCREE_RADII + 1);
  }
  return c;
}

// Likewise the inputs that only pairs with surfaces have.
template <class Read, class AnyContact>
inline void load_surface(const Read& read, AnyContact& c) {
  c.at_surface = true;
  load(c.normal_change, read, SCREE_NORMAL_CHANGE);
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
template <class Kernel, class History>
inline double released_energy(const Kernel& kernel, const History& history) {
  if constexpr (requires { kernel.stored_energy(history); })
    return kernel.stored_energy(history);
  else
    return 0;
}

// Keeps values where a condition holds and sets them to 0 elsewhere. Uses bit masks, because compilers turn
// selections into branches and second stores.
class KeepIf {
 public:
  explicit KeepIf(bool condition)
      : mask_(std::bit_cast<std::uint64_t>(condition ? std::bit_cast<double>(~std::uint64_t(0)) : 0.0)) {}
  double operator()(double value) const {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & mask_);
  }

 private:
  std::uint64_t mask_;
};

// Whether a kernel tells steps backwards in time from others (Contact::backwards). It is compiled for either
// direction, so that steps forwards pay nothing.
template <class Kernel>
inline constexpr bool follows_backwards = requires {
  requires Kernel::follows_backwards;
};

// Likewise for batches with pairs soon after first touch or before parting (Contact::onset), which are few.
template <class Kernel>
inline constexpr bool follows_onset = requires {
  requires Kernel::follows_onset;
};

// Likewise for batches of pairs with surfaces (Contact::at_surface).
template <class Kernel>
inline constexpr bool follows_surfaces = requires {
  requires Kernel::follows_surfaces;
};

inline bool any_onset(const scree_contact_batch& batch) {
  std::uint32_t near = 0;
  for (std::uint32_t i = 0; i < batch.count; ++i) near += batch.input[SCREE_ONSET_WEIGHT][i] != 1;
  return near > 0;
}

// Flattened, because the loop vectorises only when the author's functions are inlined completely; not inlined
// itself, so that a test can find it in the machine code.
template <class Parameters, class Kernel, int D, bool audit, bool backwards, bool onset, bool at_surface>
[[gnu::flatten, gnu::noinline]] void evaluate_batch(const Parameters& parameters,
                                                    const scree_contact_batch& shared) {
  using History = typename Kernel::template History<D, double>;
  constexpr std::uint32_t width = history_width<Kernel, D>;
  // Local copies: the compiler need not assume that writing a column changes them.
  const Kernel kernel{parameters};
  const scree_contact_batch batch = shared;
  const std::uint32_t count = batch.count & ~(SCREE_LANES - 1);
  const double step = batch.step, kick = batch.kick;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto read = [&](std::uint32_t k) { return batch.input[k][i]; };
    auto contact = load_contact<Kernel, D>(read, step, kick);
    contact.backwards = backwards;
    contact.onset = onset;
    if constexpr (at_surface) load_surface(read, contact);
    History history{};
    each_component<width, double>(history,
                                  [&](std::uint32_t k, double& value) { value = batch.history[k][i]; });
    const double released = audit ? released_energy(kernel, history) : 0;

    LawOutput<D, double, Kernel::writes_couple> out{};
    kernel.force(contact, history, out);

    const bool touching = contact.overlap > 0;
    const KeepIf keep(touching);
    each_component<width, double>(history,
                                  [&](std::uint32_t k, double& value) { batch.history[k][i] = keep(value); });
    for (int k = 0; k < D; ++k) batch.output[SCREE_FORCE + k][i] = keep(out.force[k]);
    if constexpr (Kernel::writes_couple)
      for (int k = 0; k < spin_components<D>; ++k) batch.output[SCREE_COUPLE + k][i] = keep(out.couple[k]);
    if constexpr (audit) {
      batch.output[SCREE_ELASTIC_NORMAL][i] = keep(out.elastic_normal);
      batch.output[SCREE_ELASTIC_TANGENTIAL][i] = keep(out.elastic_tangential);
      batch.output[SCREE_DISSIPATION_RATE_NORMAL][i] = keep(out.dissipation_rate_normal);
      batch.output[SCREE_DISSIPATION_RATE_TANGENTIAL][i] = keep(out.dissipation_rate_tangential);
      batch.output[SCREE_DISSIPATION_RATE_ROLLING][i] = keep(out.dissipation_rate_rolling);
      batch.output[SCREE_DISSIPATED_FRICTION][i] = keep(out.dissipated_friction);
      batch.output[SCREE_DISSIPATED_RELEASE][i] = touching ? out.dissipated_release : released;
    }
  }
}

template <class Parameters, class Kernel, int D, bool audit, bool at_surface>
void evaluate_either_way(const Parameters& parameters, const scree_contact_batch& batch) {
  if constexpr (follows_backwards<Kernel>) {
    if (batch.step < 0)
      return evaluate_batch<Parameters, Kernel, D, audit, true, false, at_surface>(parameters, batch);
  }
  if constexpr (follows_onset<Kernel>) {
    if (any_onset(batch))
      return evaluate_batch<Parameters, Kernel, D, audit, false, true, at_surface>(parameters, batch);
  }
  evaluate_batch<Parameters, Kernel, D, audit, false, false, at_surface>(parameters, batch);
}

template <class Parameters, class Kernel, int D, bool audit>
void evaluate_partners(const Parameters& parameters, const scree_contact_batch& batch) {
  if constexpr (follows_surfaces<Kernel>) {
    if (batch.input[SCREE_NORMAL_CHANGE])
      return evaluate_either_way<Parameters, Kernel, D, audit, true>(parameters, batch);
  }
  evaluate_either_way<Parameters, Kernel, D, audit, false>(parameters, batch);
}

template <class Parameters, class Kernel, int D>
void evaluate_contacts(const void* storage, const scree_contact_batch* batch) {
  const Parameters& parameters = *static_cast<const Parameters*>(storage);
  if (batch->output[SCREE_ELASTIC_NORMAL])
    evaluate_partners<Parameters, Kernel, D, true>(parameters, *batch);
  else
    evaluate_partners<Parameters, Kernel, D, false>(parameters, *batch);
}

}  // namespace scree::detail
