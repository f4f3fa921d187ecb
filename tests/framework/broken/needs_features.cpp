// A plug-in that requires features that the host does not have.
#include <scree/plugin/body_force.hpp>

namespace {

struct NeedsFeatures {
  static constexpr scree::About about = {"needs_features", "requires too much", "f = 0", "—"};
  void declare(scree::Declaration&) {}
  void act(const scree::BodyState&, scree::BodyForceOutput&) const {}
};

const scree_body_force body_force = {sizeof(scree_body_force), sizeof(NeedsFeatures),
                                     &scree::configure_author<NeedsFeatures>,
                                     &scree::detail::apply_body_force<NeedsFeatures>, nullptr};

}  // namespace

extern "C" __attribute__((visibility("default"))) const scree_plugin* scree_plugin_query(void) {
  static scree_plugin plugin = *scree::manifest_of<NeedsFeatures>(SCREE_BODY_FORCE, body_force);
  plugin.features = 0x8;
  return &plugin;
}
