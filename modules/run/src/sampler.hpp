#pragma once

#include "series.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <scree/probes.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::run {

// Whether something that happens every so often (s) is due after so many time steps: at the step nearest to
// each multiple, so that no rounding adds up.
bool is_due(std::uint64_t steps, double every, double step);
// After how many steps it is due next.
std::uint64_t next_due(std::uint64_t steps, double every, double step);

inline constexpr std::uint64_t never = ~std::uint64_t(0);

// The probes of a plan while it runs, each with its series.
class Sampler {
 public:
  explicit Sampler(const scenario::Plan& plan);

  // Creates the CSV files in a folder, if there are probes.
  void open(const std::filesystem::path& folder);
  // Keeps the rows in memory alone.
  void open();
  // Takes the samples that are due so many steps after the beginning of a stage. Returns when the next are.
  std::uint64_t sample(const Simulation& simulation, const std::string& stage, std::uint64_t steps);
  // One more sample of the probes of that stage where a run ends, whatever is due.
  void sample_last(const Simulation& simulation, const std::string& stage);
  void flush();
  // Of the probe of that name.
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
