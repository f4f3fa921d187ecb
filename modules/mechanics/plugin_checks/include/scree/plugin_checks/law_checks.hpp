#pragma once

#include <filesystem>

#include <scree/parameters.hpp>
#include <scree/plugin_checks/check.hpp>

namespace scree::plugin_checks {

// Bodies with which a law is checked.
struct CheckedPair {
  double radius = 0.005;  // (m) of the smaller body; the other is 1.5 times as large
  double density = 2000;  // (kg/m³)
  double speed = 0.1;     // (m/s) of impacts
};

// What every contact law must satisfy, in 2D and 3D: symmetry under exchange of the bodies and under
// rotation, no force and no history apart, the same bits in batches of any size and at every instruction
// level, derivatives that agree with finite differences, finite results at the limits of its parameters,
// closed energy and momentum balances in impacts, and closed forms that agree with these. library: the law's
// .so, as found by PluginHost. Each family of checks runs in a process of its own, for at most `longest`
// seconds: a law that ends the process or does not return fails it. Throws Error if the parameters are
// refused.
Checks check_law(const Parameters& law, const std::filesystem::path& library, const CheckedPair& pair,
                 double longest = 60);

}  // namespace scree::plugin_checks
