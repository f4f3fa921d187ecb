#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <scree/error.hpp>
#include <scree/files/descriptor.hpp>
#include <scree/run/input_hashes.hpp>
#include <scree/run/result_kind.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/stage.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

// What every study takes from its caller.
struct SessionOptions {
  std::filesystem::path out;  // empty: RunDirectory::default_for() the scenario, numbered if it exists
  bool overwrite = false;
  std::function<void(double share, double wall_time, const std::string& what)> on_progress;
  std::function<void(const std::string&)> on_warning;  // one line "<what>; <cure>"
  const std::atomic<bool>* stop = nullptr;             // set by Ctrl-C: what is complete is saved
};

// The part of the options of a study that its session takes.
template <class Options>
SessionOptions session_options(const Options& o) {
  return {o.out, o.overwrite, o.on_progress, o.on_warning, o.stop};
}

// Wall time since its start, and how much of it was spent on output.
class Stopwatch {
 public:
  double total() const { return seconds(start_, Clock::now()); }  // (s)
  double output() const { return output_; }                       // (s)

  // Calls work(), whose duration counts as output, and returns its result.
  template <class Work>
  auto time_output(const Work& work) {
    const Counted counted{*this, Clock::now()};
    return work();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
  }
  struct Counted {
    Stopwatch& watch;
    Clock::time_point start;
    ~Counted() { watch.output_ += seconds(start, Clock::now()); }
  };

  Clock::time_point start_ = Clock::now();
  double output_ = 0;
};

// When states are due, as [checkpoint] of the scene says: by wall time since the last one, and by simulated
// time.
class Cadence {
 public:
  // Wall time counts from 0 s, simulated time from t = 0.
  explicit Cadence(const scenario::CheckpointPlan& plan) : every_(plan.every), every_time_(plan.every_time) {}

  bool is_on() const { return every_ || every_time_; }
  // Whether a state is due by wall time (s).
  bool is_due(double wall_time) const { return every_ && wall_time - last_wall_ >= *every_; }
  // Whether one is due by either, at the simulated time (s) of a state: the first after each multiple of
  // every_time.
  bool is_due(double wall_time, double time) const {
    return is_due(wall_time) || (every_time_ && multiple_of(time) > multiple_of(last_time_));
  }
  void restart(double wall_time, double time) { last_wall_ = wall_time, last_time_ = time; }

 private:
  double multiple_of(double time) const {
    constexpr double slack = 1e-9;  // round-off of a time that is a sum of steps
    return std::floor(time / *every_time_ + slack);
  }

  std::optional<double> every_, every_time_;  // (s)
  double last_wall_ = 0, last_time_ = 0;      // (s)
};

// Room on the disk, kept by a file so that the record of a run can still be written when the disk is full.
class SpareRoom {
 public:
  static constexpr const char* file_name = ".room";
  static constexpr std::size_t size = 1u << 16;  // (bytes) besides that of the present record

  SpareRoom() = default;
  ~SpareRoom() { release(); }
  SpareRoom(const SpareRoom&) = delete;
  SpareRoom& operator=(const SpareRoom&) = delete;

  // Lists the file in a directory, and keeps room for its record, a file which is there. Throws Error
  // (failure) if the disk has no room for it. Where a file system or a limit on file sizes does not allow
  // such a file, there is none.
  void reserve(const RunDirectory& directory, const char* record);
  // Gives the room back. A file of another process that has the name by now stays.
  void release();

 private:
  std::filesystem::path path_;
  files::Descriptor file_;
};

// What a session asks of a study: its physics. session.cpp begins with the order of these calls.
class Study {
 public:
  virtual ~Study() = default;

  // Everything before the first file of a new study. Throws Error (bad_input) at what it cannot do.
  virtual void prepare() = 0;
  // The same for a study that goes on. Throws Error (bad_input) if the state does not fit; changes no file.
  virtual void restore(const State&) {}
  // Creates its files besides the record and the scenario. If it throws, all files are removed again.
  virtual void open() {}
  // Cuts its files to the lengths that they had at the time of the state.
  virtual void reopen() {}
  // Works to its end and writes its results. Returns false if it was stopped before its end.
  virtual bool work() = 0;

  // Whether bad input that is found in work() leaves results that are worth keeping.
  virtual bool has_results() const { return true; }
  // After an error: completes what the record tells, and then, after the record, saves what there is.
  virtual void end_failed() {}
  virtual void save_failed() {}

  // Saves or restores what the study keeps in states besides what Session::transfer() does.
  virtual void transfer(const StateTransfer&) {}
  // The entries of the record between "status" and "warnings".
  virtual nlohmann::ordered_json record() = 0;
  // Of the record: the options of the command, by their names, which change what the study finds; an empty
  // object if the scenario says all. The report repeats them.
  virtual nlohmann::ordered_json options() const;
};

// What a study does not care about: directory, lock, room for the last record on a full disk, record and
// status, warnings, progress, stop, states, failure, and going on. Functions that write throw Error
// (failure).
class Session {
 public:
  // Of new results: takes their directory. Throws Error as RunDirectory::of_results().
  Session(const ResultKind& kind, const scenario::Plan& plan, SessionOptions options);
  // Of results that go on, or begin anew, in the directory where they are.
  Session(const ResultKind& kind, const scenario::Plan& plan, SessionOptions options, RunDirectory directory);

  // Carries out a study from its start, or from the state of a file. Throws its errors; those after the first
  // file are recorded.
  void begin(Study& study);
  void resume(Study& study, const State& state, const std::filesystem::path& file);

  const RunDirectory& directory() const { return directory_; }
  const InputHashes& inputs() const { return inputs_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  bool interrupted() const { return interrupted_; }

  // For the study while it works.
  bool proceeds() const { return !options_.stop || !*options_.stop; }
  void report(double share, const std::string& what) const;
  void warn(const std::string& line);
  // Keeps warnings that are reported later.
  void note(const std::vector<std::string>& lines);
  // Runs stages [present, end) without probes; false after a stop.
  bool run_stages(StageRunner& stages, std::size_t end) const;
  // The error of a stop before the first file.
  Error stopped_before(const std::string& what) const;
  Stopwatch& watch() { return watch_; }
  double wall_time() const {
    return wall_time_before_ + watch_.total();
  }  // (s), also before it was interrupted
  void restart_watch() { watch_ = {}; }
  // Writes the record of a study that goes on.
  void record_running() { write_record("running"); }

  // Whether a state at a simulated time (s) is to be written now.
  bool is_state_due(double time) const { return cadence_.is_due(wall_time(), time); }
  // Adds what the study keeps to a state of its simulation, and writes it: now if it is the first or due,
  // else when the study ends early. One that is due but cannot be written is a warning.
  void keep(State state, double time);

  // Of states: scenario, warnings, inputs and wall time. For studies with other states: warnings and inputs
  // alone.
  void transfer(const StateTransfer& state);
  void transfer_notes(const StateTransfer& state);

 private:
  void carry_out(const std::function<void()>& start);
  void end(bool complete);
  void fail(const std::string& reason, ExitStatus status);
  void write_record(const char* status);
  void write_page();
  void remove_page();
  void write_kept_state();

  const ResultKind& kind_;
  const scenario::Plan& plan_;
  SessionOptions options_;
  RunDirectory directory_;
  bool in_place_;  // whether it cannot take another directory
  Study* study_ = nullptr;
  InputHashes inputs_;
  std::vector<std::string> warnings_;              // "<what>; <cure>"
  std::string error_;                              // one line, if it failed
  ExitStatus error_status_ = ExitStatus::failure;  // of the program then
  bool interrupted_ = false, first_state_ = true, state_failed_ = false;
  std::optional<State> kept_;  // the latest state that is not in the file
  Cadence cadence_;
  SpareRoom room_;
  Stopwatch watch_;
  double wall_time_before_ = 0;  // (s)
};

}  // namespace scree::run
