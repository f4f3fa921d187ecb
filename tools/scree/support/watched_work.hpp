#pragma once

#include "support/progress_bar.hpp"
#include "support/verbs.hpp"

#include <string>

namespace scree::tool {

// Options of a work that shows its progress on a bar and ends at Ctrl-C: of sound, vibration. The bar must
// outlive them.
template <class Options>
Options watched(Options options, ProgressBar& bar) {
  options.stop = &watch_for_interrupt();
  options.on_progress = [&bar](double share, double wall_time, const std::string& what) {
    bar.show(share, wall_time, what);
  };
  options.on_warning = [&bar](const std::string& line) {
    bar.clear();
    report_warning(line);
  };
  return options;
}

// The result of a work with such options.
template <class Options, class Work>
auto watch(bool quiet, const Work& work) {
  ProgressBar bar(quiet);
  return work(watched(Options(), bar));
}

}  // namespace scree::tool
