// A plug-in built against another version of the interface.
#include <scree/plugin/abi.h>

extern "C" __attribute__((visibility("default"))) const scree_plugin* scree_plugin_query(void) {
  static scree_plugin plugin = {};
  plugin.struct_size = sizeof(plugin);
  plugin.abi_version = SCREE_ABI_VERSION + 1;
  return &plugin;
}
