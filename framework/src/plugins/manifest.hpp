#pragma once

#include <optional>
#include <string>

#include <scree/plugin/abi.h>

namespace scree {

// What makes a manifest unusable, as "<problem>; <remedy>": the host reads all of it unchecked afterwards.
// The interface version is checked first, because the rest is only defined for the host's own.
std::optional<std::string> manifest_problem(const scree_plugin* plugin);

}  // namespace scree
