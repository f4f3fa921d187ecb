#pragma once

#include "support/verbs.hpp"

#include <string>
#include <vector>

namespace scree::tool {

// What `scree spectrum` takes.
struct SpectrumArguments {
  std::string csv, column, out, detrend = "linear";
  double frequency = 0;  // 0: not given
  std::string scenario, by;
  std::vector<std::string> overrides;
  unsigned threads = 1;
  bool overwrite = false, resume = false, quiet = false;
  PluginOptions plugins;
};

// The words of --detrend: degrees of a polynomial from 0, and the mean over a period.
inline const std::vector<std::string> detrendings = {"constant", "linear", "quadratic", "cubic",
                                                     "period-average"};

// Adds the verb `spectrum` with its options; the caller gives it its action.
Verb add_spectrum_options(CommandLine& line, SpectrumArguments& arguments);

}  // namespace scree::tool
