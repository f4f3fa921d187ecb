#pragma once

#include <exception>

namespace scree::files {

// Calls every function, even if others throw; their exceptions are discarded. For work after an error, which
// is then the one to report.
template <class... Work>
void try_each(const Work&... work) {
  const auto attempt = [](const auto& one) {
    try {
      one();
    } catch (const std::exception&) {
    }
  };
  (attempt(work), ...);
}

}  // namespace scree::files
