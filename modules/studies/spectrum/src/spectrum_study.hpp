#pragma once

#include "measurement_files.hpp"
#include "start.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <scree/run/session.hpp>
#include <scree/spectrum/measurement.hpp>
#include <scree/stage.hpp>

namespace scree::spectrum {

// The study of a spectrum, from its start (measurement.cpp) or from a state (resume.cpp) to its last file.
class SpectrumStudy : public run::Study {
 public:
  SpectrumStudy(const scenario::Plan& plan, SpectrumPlan spectrum, const MeasurementOptions& options,
                run::Session& session)
      : plan_(plan),
        spectrum_(std::move(spectrum)),
        options_(options),
        session_(session),
        directory_(session.directory()),
        asked_(options.methods) {
    result_.title = plan.heading();
    result_.observed = spectrum_.observed;
  }

  // The stages, if they have not run in prepare(); then each method that is asked for, the short ones first;
  // then peaks, tables and charts of what is complete.
  bool work() override;

  // What is there stays until something can take its place: with overwrite the stages run before anything is
  // written.
  void prepare() override;
  void restore(const State& state) override;
  bool has_results() const override { return sweep_ || !result_.spectra.empty(); }
  void save_failed() override {
    if (sweep_) write_sweep_table();
  }
  void transfer(const StateTransfer& state) override;
  nlohmann::ordered_json record() override { return record_of(result_); }
  // By which methods it was asked for, of which some may have been left out.
  nlohmann::ordered_json options() const override {
    const bool one = asked_.size() == 1 && left_out_.empty();
    return {{"by", one ? method_names[std::size_t(asked_[0])] : "all"}};
  }

  Measurement result() {
    result_.directory = directory_.path();
    result_.interrupted = session_.interrupted();
    result_.inputs = session_.inputs();
    result_.warnings = session_.warnings();
    return std::move(result_);
  }

 private:
  void set_start(State state);
  void check_start() const;
  bool run_stages_in_directory();
  void keep_in_stages();

  bool asks(Method method) const { return std::find(asked_.begin(), asked_.end(), method) != asked_.end(); }
  bool has(const std::string& method) const {
    return std::any_of(result_.spectra.begin(), result_.spectra.end(),
                       [&](const auto& r) { return r.method == method; });
  }
  void take_linear();
  void take_pulse();
  // Measures by a method that is not a sweep. A method that fails is skipped if there are others.
  template <class Take>
  void take(Method method, const Take& take);
  void take_sweep();
  // The state with which a study without a sweep goes on.
  void keep_without_sweep();
  void keep_sweep();
  void write_sweep_table();
  void find_peaks(bool complete);
  void judge();

  const scenario::Plan& plan_;
  const SpectrumPlan spectrum_;
  const MeasurementOptions& options_;
  run::Session& session_;
  const run::RunDirectory& directory_;
  std::vector<Method> asked_;
  std::vector<std::string> left_out_;  // asked for, but could not be taken
  Measurement result_;
  MethodSpectrum unfinished_;               // linear method of a part of the frequencies
  std::unique_ptr<Simulation> simulation_;  // in the stages
  std::optional<StageRunner> stages_;
  std::optional<Start> start_;  // after the stages
  std::unique_ptr<Sweep> sweep_;
  double last_table_ = 0;  // (s) of wall time
};

}  // namespace scree::spectrum
