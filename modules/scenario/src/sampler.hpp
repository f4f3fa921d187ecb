#pragma once

#include "series.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <scree/probes.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::scenario {

// Time steps in a duration, at least one.
std::uint64_t steps_in(double duration, double step);

// The probes of a plan while it runs, each with its series.
class Sampler {
 public:
  Sampler(const Plan& plan, double step);

  // Creates the CSV files in a folder, if there are probes.
  void open(const std::filesystem::path& folder);
  // Takes the samples that are due so many steps after the beginning of a stage.
  void sample(const Simulation& simulation, const std::string& stage, std::uint64_t steps);
  void flush();
  // Of the probe of that name.
  const Series& series(const std::string& probe) const;

 private:
  struct Active {
    const ProbePlan* plan;
    Probe probe;
    std::uint64_t interval;  // steps
    std::unique_ptr<Series> series = nullptr;

    bool due(const std::string& stage, std::uint64_t steps) const;
  };

  std::vector<Active> probes_;
};

}  // namespace scree::scenario
