// A plug-in without a manifest.
#include <scree/plugin/abi.h>

extern "C" __attribute__((visibility("default"))) const scree_plugin* scree_plugin_query(void) {
  return nullptr;
}
