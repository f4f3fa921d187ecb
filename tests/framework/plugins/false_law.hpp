#pragma once

#include <string>

#include <scree/plugin_host.hpp>

// A contact law as a plug-in might wrongly provide it, without a library.

namespace scree::test {

struct FalseLaw {
  scree_contact_law law = {sizeof(scree_contact_law), 64, 1u << 2 | 1u << 3, &configure, &two_forms};
  scree_plugin plugin = {.struct_size = sizeof(scree_plugin),
                         .abi_version = SCREE_ABI_VERSION,
                         .kind = SCREE_CONTACT_LAW,
                         .parameter_count = 0,
                         .features = 0,
                         .numerics = 0,
                         .parameter_size = sizeof(scree_parameter),
                         .name = "false_law",
                         .summary = "for a test",
                         .equation = "f = 0",
                         .source = "none",
                         .parameters = nullptr,
                         .interface = &law};

  FalseLaw() = default;
  FalseLaw(const FalseLaw&) = delete;
  FalseLaw& operator=(const FalseLaw&) = delete;

  ConfiguredLaw configured() const { return {Parameters(plugin), 3, no_bounds, no_bounds}; }

  static void evaluate(const void*, const scree_contact_batch*) {}
  static int configure(const scree_setup*, void*, scree_contact_instance* instance) {
    *instance = {};
    instance->sliding_column = -1;
    instance->evaluate = &evaluate;
    return 0;
  }
  static std::uint32_t two_forms(const void*, const scree_encounter*, scree_closed_form* forms,
                                 std::uint32_t) {
    forms[0] = {"contact_time", "s", "t", 1e-3};
    forms[1] = {"restitution", "", "r", 1};
    return 2;
  }
};

}  // namespace scree::test
