// A plug-in as a later version of the interface might build it.

#include <scree/plugin/abi.h>

extern "C" __attribute__((visibility("default"))) const scree_plugin* scree_plugin_query() {
  static const scree_plugin plugin = [] {
    scree_plugin p = {};
    p.struct_size = sizeof(p);
    p.abi_version = SCREE_ABI_VERSION + 41;
    p.kind = SCREE_CONTACT_LAW;
    p.name = "other_version";
    return p;
  }();
  return &plugin;
}
