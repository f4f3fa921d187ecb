#pragma once

#include "series.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <scree/probes.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::run {

// Whether output with the interval `every` (s) is due after `steps` time steps of length `step` (s): at the
// step nearest to each multiple of the interval, so that rounding errors do not accumulate.
bool is_due(std::uint64_t steps, double every, double step);
// Number of steps at which it is due next.
std::uint64_t next_due(std::uint64_t steps, double every, double step);

inline constexpr std::uint64_t never = ~std::uint64_t(0);

// The probes of a run, each with its series.
class Sampler {
 public:
  explicit Sampler(const scenario::Plan& plan);

  // Writes the rows to CSV files in a folder, created if there are probes.
  void open(const std::filesystem::path& folder);
  // Keeps the rows in memory only.
  void open();
  // Takes the samples due `steps` after the start of a stage. Returns the step count of the next samples.
  std::uint64_t sample(const Simulation& simulation, const std::string& stage, std::uint64_t steps);
  // Takes a final sample of the probes of the stage at the end of a run.
  void sample_last(const Simulation& simulation, const std::string& stage);
  void flush();
  // Series of a probe, by name.
  const Series& series(const std::string& probe) const;

 private:
  struct Active {
    const scenario::ProbePlan* plan;
    Probe probe;
    std::unique_ptr<Series> series = nullptr;

    bool samples_in(const std::string& stage) const;
  };
  template <class Due>
  void sample_where(const Simulation& simulation, const Due& due);

  std::vector<Active> probes_;
};

}  // namespace scree::run
