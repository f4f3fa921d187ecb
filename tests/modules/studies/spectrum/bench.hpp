#pragma once

#include "chain.hpp"

#include <filesystem>
#include <string>

#include <scree/spectrum/measurement.hpp>

namespace scree::test {

// A scene with a spectrum by all methods, in a directory of its own.
struct Bench {
  TemporaryFolder folder;
  scenario::Plan plan;
  spectrum::MeasurementOptions options;

  explicit Bench(const std::string& text, const std::vector<std::string>& overrides = {})
      : plan(driven_plan_of(text, overrides)) {
    options.out = folder / "out";
    options.methods = {spectrum::Method::linear, spectrum::Method::pulse, spectrum::Method::sweep};
  }
  std::string text(const std::string& name) const { return text_of(options.out / name); }
  bool has(const std::string& name) const { return std::filesystem::exists(options.out / name); }
};

}  // namespace scree::test
