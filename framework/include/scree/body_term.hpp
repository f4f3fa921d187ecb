#pragma once

#include <scree/declaration.hpp>
#include <scree/plugin_abi.h>

// How to write a body term: plugins/README.md. An author's struct has
//
//   static constexpr scree::About about;
//   void declare(scree::Declaration&);
//   void prepare(const scree::Setup&);          optional: derived values, refusals
//   void apply(scree_body_batch&) const;        adds forces, torques, energies; columns may be NULL

namespace scree::detail {

template <class Author>
void apply_body_term(const void* storage, scree_body_batch* batch) {
  static_cast<const Author*>(storage)->apply(*batch);
}

}  // namespace scree::detail

#define SCREE_BODY_TERM_PLUGIN(Author)                                                      \
  static const scree_body_term scree_interface = {sizeof(scree_body_term), sizeof(Author),  \
                                                  &scree::configure_author<Author>,         \
                                                  &scree::detail::apply_body_term<Author>}; \
  SCREE_EXPORT_PLUGIN((scree::manifest_of<Author>(SCREE_BODY_TERM, scree_interface)))
