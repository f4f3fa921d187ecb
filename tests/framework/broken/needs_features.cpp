// A plug-in that asks the host for what it does not have.
#include <scree/body_term.hpp>

namespace {

struct NeedsFeatures {
  static constexpr scree::About about = {"needs_features", "asks too much", "f = 0", "—"};
  void declare(scree::Declaration&) {}
  void act(const scree::BodyState&, scree::BodyResponse&) const {}
};

const scree_body_term body_term = {sizeof(scree_body_term), sizeof(NeedsFeatures),
                                   &scree::configure_author<NeedsFeatures>,
                                   &scree::detail::apply_body_term<NeedsFeatures>, nullptr};

}  // namespace

extern "C" __attribute__((visibility("default"))) const scree_plugin* scree_plugin_query(void) {
  static scree_plugin plugin = *scree::manifest_of<NeedsFeatures>(SCREE_BODY_TERM, body_term);
  plugin.features = 0x8;
  return &plugin;
}
