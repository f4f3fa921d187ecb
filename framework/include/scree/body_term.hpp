#pragma once

#include <scree/declaration.hpp>
#include <scree/plugin_abi.h>

// How to write a body term: plugins/README.md. An author's struct has
//
//   static constexpr scree::About about;
//   void declare(scree::Declaration&);
//   void prepare(const scree::Setup&);          optional: derived values, refusals
//   void apply(scree_body_batch&) const;        adds forces, torques, energies; columns may be NULL
//   double damping_rate(double mass, double inertia, double radius) const;
//                                               optional: how fast it slows a body (1/s), for the step guard

namespace scree::detail {

template <class Author>
void apply_body_term(const void* storage, scree_body_batch* batch) {
  static_cast<const Author*>(storage)->apply(*batch);
}

template <class Author>
double damping_rate_of(const void* storage, double mass, double inertia, double radius) {
  if constexpr (requires(const Author& author) { author.damping_rate(mass, inertia, radius); })
    return static_cast<const Author*>(storage)->damping_rate(mass, inertia, radius);
  else
    return 0;
}

}  // namespace scree::detail

#define SCREE_BODY_TERM_PLUGIN(Author)                                                   \
  static const scree_body_term scree_interface = {                                       \
      sizeof(scree_body_term), sizeof(Author), &scree::configure_author<Author>,         \
      &scree::detail::apply_body_term<Author>, &scree::detail::damping_rate_of<Author>}; \
  SCREE_EXPORT_PLUGIN((scree::manifest_of<Author>(SCREE_BODY_TERM, scree_interface)))
