#pragma once

#include <string>
#include <vector>

namespace scree::plugin_checks {

// Result of one check of a plug-in.
struct Check {
  enum class Verdict { passed, failed, skipped };

  std::string name;  // what must hold, in words
  Verdict verdict = Verdict::passed;
  std::string detail;  // what was measured, or why the check was skipped
};

using Checks = std::vector<Check>;

}  // namespace scree::plugin_checks
