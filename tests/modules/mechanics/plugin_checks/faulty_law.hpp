#pragma once

#include <algorithm>
#include <string>

#include <scree/parameters.hpp>
#include <scree/plugin_checks/check.hpp>
#include <scree/plugin_checks/law_checks.hpp>
#include <scree/plugin_host.hpp>

// A spring and dashpot with a mistake of choice, laws/faulty.cpp.

namespace scree::test {

enum Fault {
  none,
  asymmetric,
  anisotropic,
  creates_energy,
  unbalanced,
  derivative,
  infinite,
  restitution,
  duration,
  sideways
};

inline PluginHost& host_of_laws() {
  static PluginHost host({SCREE_TEST_LAWS});
  return host;
}

inline Parameters faulty(Fault fault) {
  Parameters law(host_of_laws().find("faulty", SCREE_CONTACT_LAW));
  law.set("stiffness", {5000});
  law.set("damping", {1});
  law.set("fault", {double(fault)});
  return law;
}

inline constexpr plugin_checks::CheckedPair checked_pair = {.speed = 0.1};

// The names of the checks that failed, separated by "; ".
inline std::string failed(const plugin_checks::Checks& checks) {
  std::string names;
  for (const plugin_checks::Check& check : checks)
    if (check.verdict == plugin_checks::Check::Verdict::failed)
      names += (names.empty() ? "" : "; ") + check.name;
  return names;
}

}  // namespace scree::test
