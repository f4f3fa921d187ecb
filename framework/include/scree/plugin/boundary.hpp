#pragma once

#include <scree/plugin/abi.h>
#include <scree/plugin/declaration.hpp>

// How to write a boundary: plugins/README.md. An author's struct has
//
//   static constexpr scree::About about;
//   void declare(scree::Declaration&);
//   void prepare(const scree::Setup&);              optional: derived values, refusals
//   void describe(scree_boundary_instance&) const;  planes, state doubles, periodic axes
//   void start(const scree_boundary_step&) const;   planes and state at the start
//   void begin_step(const scree_boundary_step&) const;    planes from t to t + step
//   void finish_step(const scree_boundary_step&) const;   velocities and energies at t + step
//
// `begin_step` also sets mid_velocity, displacement / step, and velocity, predicted for t + step.
// `finish_step` receives the loads at t + step; it is called once with step 0 for the initial loads. Neither
// is called while the instance has set `still`.

namespace scree::detail {

template <class Author>
int configure_boundary(const scree_setup* setup, void* storage, scree_boundary_instance* instance) {
  if (const int failed = configure_author<Author>(setup, storage)) return failed;
  *instance = {};
  instance->struct_size = sizeof(*instance);
  static_cast<const Author*>(storage)->describe(*instance);
  return 0;
}
template <class Author>
void start_boundary(const void* storage, const scree_boundary_step* step) {
  static_cast<const Author*>(storage)->start(*step);
}
template <class Author>
void begin_boundary_step(const void* storage, const scree_boundary_step* step) {
  static_cast<const Author*>(storage)->begin_step(*step);
}
template <class Author>
void finish_boundary_step(const void* storage, const scree_boundary_step* step) {
  static_cast<const Author*>(storage)->finish_step(*step);
}

}  // namespace scree::detail

#define SCREE_BOUNDARY_PLUGIN(Author)                                                           \
  static const scree_boundary scree_interface = {sizeof(scree_boundary),                        \
                                                 sizeof(Author),                                \
                                                 &scree::detail::configure_boundary<Author>,    \
                                                 &scree::detail::start_boundary<Author>,        \
                                                 &scree::detail::begin_boundary_step<Author>,   \
                                                 &scree::detail::finish_boundary_step<Author>}; \
  SCREE_EXPORT_PLUGIN((scree::manifest_of<Author>(SCREE_BOUNDARY, scree_interface)))
