#pragma once

#include <scree/plugin/abi.h>
#include <scree/plugin/declaration.hpp>
#include <scree/plugin/vec.hpp>

// How to write a body force: plugins/README.md. An author's struct has
//
//   static constexpr scree::About about;
//   void declare(scree::Declaration&);
//   void prepare(const scree::Setup&);                          optional: derived values, refusals
//   void at(double time);                                       optional: derived values at a time (s) since the
//                                                               parameters were set
//   void at(double time, double before);                        the same, with the time of the evaluation before
//   void act(const scree::BodyState&, scree::BodyForceOutput&) const;
//   double damping_rate(double mass, double inertia, double radius) const;
//                                               optional: largest rate at which drag slows a body (1/s), for
//                                               the step guard

namespace scree {

// One body. Components that the scene does not carry are 0: z and the x and y spins in 2D, spin and inertia
// in a scene without spin.
struct BodyState {
  Vec3 position;                 // (m) unfolded: including the periods that the body has crossed
  Vec3 mid_position;             // (m) the same half way from the evaluation before
  Vec3 velocity;                 // (m/s)
  Vec3 spin;                     // (rad/s)
  double radius, mass, inertia;  // (m), (kg), (kg m²)
};

// Output of a body force. All members are initialised to 0.
struct BodyForceOutput {
  Vec3 force;                           // (N)
  Vec3 torque;                          // (N m) ignored in a scene without spin
  double potential;                     // (J)
  double dissipation_rate_translation;  // (W)
  double dissipation_rate_rotation;     // (W)
  double
      work;  // (J) since the evaluation before, beyond potential and drag, such as the change of the potential with
             // time alone
};

namespace detail {

// Components [first, last) of a vector, at the offset `at` (doubles) into its columns.
template <int first, int last>
inline Vec3 vector_at(const scree_column (&columns)[3], std::uint64_t at) {
  Vec3 v = {};
  for (int k = first; k < last; ++k) v[k] = columns[k].data[at];
  return v;
}

// All state columns of a batch have the same stride, and so do all load columns.
template <class Author, int D, bool with_spin, bool audit>
[[gnu::flatten]] void act_on_batch(const Author& shared, scree_body_batch& sums) {
  constexpr int first_spin = with_spin ? first_spin_axis<D> : 3;
  // Local copies: the compiler need not assume that writing a load changes them.
  Author timed = shared;
  if constexpr (requires(Author & a) { a.at(0.0, 0.0); }) timed.at(sums.time, sums.time_before);
  if constexpr (requires(Author & a) { a.at(0.0); }) timed.at(sums.time);
  const Author author = timed;
  const scree_body_batch batch = sums;
  const std::uint64_t state_stride = batch.radius.stride, load_stride = batch.force[0].stride;
  const double half_elapsed = 0.5 * (batch.time - batch.time_before);
  std::uint64_t state = 0, load = 0;
  BodyForceOutput all{};
  for (std::uint32_t i = 0; i < batch.count; ++i, state += state_stride, load += load_stride) {
    BodyState body{vector_at<0, D>(batch.position, state),
                   {},
                   vector_at<0, D>(batch.velocity, state),
                   vector_at<first_spin, 3>(batch.spin, state),
                   batch.radius.data[state],
                   batch.mass.data[i],
                   with_spin ? batch.inertia.data[i] : 0};
    for (int k = 0; k < D; ++k)
      if (batch.image[k]) body.position[k] += batch.image[k][i] * batch.period[k];
    body.mid_position = body.position - half_elapsed * body.velocity;
    BodyForceOutput out{};
    author.act(body, out);
    for (int k = 0; k < D; ++k) batch.force[k].data[load] += out.force[k];
    for (int k = first_spin; k < 3; ++k) batch.torque[k].data[load] += out.torque[k];
    if constexpr (audit) {
      all.potential += out.potential;
      all.dissipation_rate_translation += out.dissipation_rate_translation;
      all.dissipation_rate_rotation += out.dissipation_rate_rotation;
      all.work += out.work;
    }
  }
  sums.potential += all.potential;
  sums.dissipation_rate_translation += all.dissipation_rate_translation;
  sums.dissipation_rate_rotation += all.dissipation_rate_rotation;
  sums.work += all.work;
}

template <class Author, int D, bool with_spin>
void act_with_audit(const Author& author, scree_body_batch& batch) {
  if (batch.audit)
    act_on_batch<Author, D, with_spin, true>(author, batch);
  else
    act_on_batch<Author, D, with_spin, false>(author, batch);
}

template <class Author>
void apply_body_force(const void* storage, scree_body_batch* batch) noexcept {
  const Author& author = *static_cast<const Author*>(storage);
  const bool with_spin = bool(batch->torque[2]);
  if (batch->dimension == 2)
    with_spin ? act_with_audit<Author, 2, true>(author, *batch)
              : act_with_audit<Author, 2, false>(author, *batch);
  else
    with_spin ? act_with_audit<Author, 3, true>(author, *batch)
              : act_with_audit<Author, 3, false>(author, *batch);
}

template <class Author>
double damping_rate_of(const void* storage, double mass, double inertia, double radius) {
  if constexpr (requires(const Author& author) { author.damping_rate(mass, inertia, radius); })
    return static_cast<const Author*>(storage)->damping_rate(mass, inertia, radius);
  else
    return 0;
}

}  // namespace detail

}  // namespace scree

#define SCREE_BODY_FORCE_PLUGIN(Author)                                                   \
  static const scree_body_force scree_interface = {                                       \
      sizeof(scree_body_force), sizeof(Author), &scree::configure_author<Author>,         \
      &scree::detail::apply_body_force<Author>, &scree::detail::damping_rate_of<Author>}; \
  SCREE_EXPORT_PLUGIN((scree::manifest_of<Author>(SCREE_BODY_FORCE, scree_interface)))
