#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <scree/probes.hpp>
#include <scree/run/series.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/until.hpp>

namespace scree::run {

// Whether output with the interval `every` (s) is due after `steps` time steps of length `step` (s): at the
// step nearest to each multiple of the interval, so that rounding errors do not accumulate.
bool is_due(std::uint64_t steps, double every, double step);
// Number of steps at which it is due next; `never` beyond 2^53 steps.
std::uint64_t next_due(std::uint64_t steps, double every, double step);

inline constexpr std::uint64_t never = ~std::uint64_t(0);

// The probes of a run, each with its series. Probes that observe do so on a clock of their own, so that what
// they keep does not depend on when samples are taken. A probe that reads columns of others comes after
// these.
class Sampler : public StageColumns {
 public:
  explicit Sampler(const scenario::Plan& plan);

  // Writes the rows to CSV files in a folder, created if there are probes; with several stages each row ends
  // with the number of its own.
  void open(const std::filesystem::path& folder);
  // Throws Error if what a probe keeps was restored with another size than its plug-in expects.
  void check_restored(const Simulation& simulation) const;
  // Goes on with the files of a run whose state has been restored, in the stage of this number; cut() cuts
  // them to the lengths that they had then. Throws Error if one of them is not as it was up to there; all are
  // left as they are.
  void reopen(const std::filesystem::path& folder, std::size_t stage);
  void cut();
  // Keeps the rows in memory only. Without any open() they are not kept.
  void open();
  // What the probes keep, and how far their series have come; these must be flushed.
  void transfer_probes(const StateTransfer& state);
  // Takes the observations, then the samples due `steps` after the start of a stage. Returns the step count
  // at which the next are due.
  std::uint64_t take(const Simulation& simulation, const std::string& stage, std::uint64_t steps) override;
  // Step count after the start of a stage at which the next observation or sample is due.
  std::uint64_t next(const Simulation& simulation, const std::string& stage,
                     std::uint64_t steps) const override;
  std::optional<double> value(std::size_t probe, std::size_t column) const override;
  // Takes a final sample of the probes of the stage at the end of a run; observes nothing more.
  void sample_last(const Simulation& simulation, const std::string& stage);
  // Samples from now on belong to the stage of this number, from 1.
  void begin_stage(std::size_t number);
  void flush();
  // Closes the files and forgets the rows.
  void close();
  // A line for each probe that observes the run and has columns without a value in its last row: "<what>;
  // <cure>".
  std::vector<std::string> unfilled() const;
  // Series of a probe, by name.
  const Series& series(const std::string& probe) const;

 private:
  struct Active {
    const scenario::ProbePlan* plan;
    Probe probe;
    std::unique_ptr<Series> series = nullptr;
    std::uint64_t observed = never;  // step of the last observation
    SeriesEnd end = {};              // behind which a series that is reopened goes on
    std::uint64_t sampled = never;   // step of the last sample
    std::vector<double> row = {};    // of the present time; empty if it was not computed
    std::vector<double> last = {};   // row of the series, of probes that observe

    bool records_in(const std::string& stage) const;
    // At the start of a stage, after which the clock runs anew, it may have been observed already.
    bool is_observed(const Simulation& simulation, std::uint64_t steps) const;
    bool is_due_at(const Simulation& simulation, std::uint64_t steps) const;
    // Step count at which the next observation or sample is due.
    std::uint64_t next(double step, std::uint64_t steps) const;
  };
  // What a view has that several probes see together.
  struct Shown {
    std::uint32_t needs = SCREE_NEEDS_NO_BODIES;
    ListedBodies bodies = std::vector<std::uint32_t>();
    bool any = false;
  };
  // What is observed at one time, in the stage of this name.
  struct Observed {
    const Simulation& simulation;
    const scree_view& view;
    const std::string& stage;
  };
  void put_in_order();
  // Adds what a probe reads, and what those read whose columns it reads.
  void add_needs(const Active& probe, Shown& shown) const;
  void sample(Active& probe, const Observed& now);
  // The row of the probe at this time, computed once.
  const std::vector<double>& row(Active& probe, const Observed& now);
  void forget_rows();
  // NaN of probes that do not record in the stage.
  std::vector<double> inputs_of(const Active& probe, const Observed& now);

  std::vector<Active> probes_;
  std::vector<std::size_t> order_;  // of probes_, each after those whose columns it reads
  std::uint64_t taken_step_ = never;
  std::string taken_stage_;
  bool staged_;
  double end_time_;  // (s) of the run; NaN if it is not known
};

// A sampler that outlives the runner of stages to which it gives columns.
inline std::shared_ptr<StageColumns> unowned(Sampler& sampler) {
  return {std::shared_ptr<StageColumns>(), &sampler};
}

}  // namespace scree::run
