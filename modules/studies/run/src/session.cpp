#include <cerrno>
#include <fcntl.h>
#include <new>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/files/place_error.hpp>
#include <scree/files/program_commit.hpp>
#include <scree/files/text.hpp>
#include <scree/files/try_each.hpp>
#include <scree/report/page.hpp>
#include <scree/run/session.hpp>
#include <scree/run/stage_loop.hpp>
#include <scree/state_error.hpp>
#include <scree/state_file/state_file.hpp>

// Life of a study:
//
//   new                             goes on
//     Study::prepare                  Study::restore         bad input is refused, nothing is written
//     directory                       directory              files of replaced results are removed, report.html
//     record "running", scenario      room on the disk
//     room on the disk                Study::reopen
//     Study::open
//     --- an error so far removes     --- an error so far leaves the record as it is
//         the files again
//                                     record "running", scenario
//     Study::work                     Study::work            keeps states as [checkpoint] says
//     latest state, if stopped        latest state, if stopped
//     record "finished" or "interrupted", report.html
//
//   after an error since then: Study::end_failed, record "failed" with the cure of its place, latest state,
//   Study::save_failed, report.html

namespace scree::run {

Session::Session(const ResultKind& kind, const scenario::Plan& plan, SessionOptions options)
    : Session(kind, plan, options,
              RunDirectory::of_results(options.out, options.overwrite, plan.source, plan.inputs,
                                       kind.directory)) {
  in_place_ = false;
  directory_.report_lock(options_.on_warning);
}

Session::Session(const ResultKind& kind, const scenario::Plan& plan, SessionOptions options,
                 RunDirectory directory)
    : kind_(kind),
      plan_(plan),
      options_(std::move(options)),
      directory_(std::move(directory)),
      in_place_(true),
      inputs_(hashes_of(plan.files)),
      cadence_(plan.checkpoint) {}

void Session::begin(Study& study) {
  study_ = &study;
  study.prepare();
  directory_.begin([&] {
    directory_.add(kind_.record);  // first, so that the list is known as that of these results
    // A run that is killed goes on from its text even before its first state.
    directory_.write_file(scenario_file, plan_.text_for_any_folder);
    record_running();
    room_.reserve(directory_, kind_.record);
    study.open();
  });
  carry_out([] {});
}

void Session::resume(Study& study, const State& state, const std::filesystem::path& file) {
  study_ = &study;
  with_state_of(file.string(), [&] { study.restore(state); });
  directory_.create();
  remove_page();
  room_.reserve(directory_, kind_.record);
  // Before files that follow the state are removed: killed then, the run is not taken for finished.
  record_running();
  study.reopen();
  carry_out([&] {
    if (!plan_.text_for_any_folder.empty()) directory_.write_file(scenario_file, plan_.text_for_any_folder);
  });
}

void Session::carry_out(const std::function<void()>& start) {
  try {
    start();
    end(study_->work());
  } catch (const Error& error) {
    if (!in_place_ && error.status() == ExitStatus::bad_input && !study_->has_results()) {
      directory_.discard();
      throw;
    }
    fail(files::record_line(error, in_place_), error.status());
    directory_.check_in_place();  // a better reason than the file that could not be written
    files::rethrow_as_failure(error);
  } catch (const std::exception& error) {  // such as of memory
    fail(error.what(), ExitStatus::failure);
    throw;
  }
}

void Session::end(bool complete) {
  interrupted_ = !complete;
  if (interrupted_ || kind_.keeps_state) write_kept_state();
  room_.release();
  write_record(interrupted_ ? "interrupted" : "finished");
  if (!interrupted_ && !kind_.keeps_state && kind_.state) {
    std::error_code failed;
    std::filesystem::remove(directory_.path() / kind_.state, failed);
  }
  write_page();
}

// The results are complete without it, so that they do not fail with it.
void Session::write_page() {
  try {
    directory_.write_file(report::file_name, report::page_of(directory_.path()));
  } catch (const std::exception& error) {
    if (options_.on_warning)
      options_.on_warning(fmt::format("{} is missing: {}", report::file_name, error.what()));
  }
}

nlohmann::ordered_json Study::options() const { return nlohmann::ordered_json::object(); }

// That of the results from which these go on.
void Session::remove_page() {
  std::error_code failed;
  if (directory_.written().contains(report::file_name))
    std::filesystem::remove(directory_.path() / report::file_name, failed);
}

// Further errors are discarded, so that the user sees the original one.
void Session::fail(const std::string& reason, ExitStatus status) {
  constexpr std::size_t longest_line = 2000;
  error_ = files::one_line(reason, longest_line);
  error_status_ = status == ExitStatus::bad_input ? ExitStatus::failure : status;  // results are there
  files::try_each([&] { study_->end_failed(); },
                  [&] {
                    room_.release();
                    write_record("failed");
                  },
                  [&] { write_kept_state(); }, [&] { study_->save_failed(); },
                  [&] { directory_.write_file(report::file_name, report::page_of(directory_.path())); });
}

void Session::write_record(const char* status) {
  using Json = nlohmann::ordered_json;
  Json json = {{"version", SCREE_VERSION}, {"commit", files::program_commit()}, {"status", status}};
  if (!error_.empty()) json.update({{"error", error_}, {"exit_status", int(error_status_)}});
  json.update(study_->record());
  if (Json options = study_->options(); !options.empty()) json["options"] = std::move(options);
  json["warnings"] = warnings_;
  json["inputs"] = json_of(inputs_);
  json["scenario"] = plan_.resolved_text;
  // replace: a path in an error message may not be valid UTF-8.
  directory_.write_file(kind_.record, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void Session::report(double share, const std::string& what) const {
  if (options_.on_progress) options_.on_progress(share, wall_time(), what);
}

void Session::warn(const std::string& line) {
  warnings_.push_back(line);
  if (options_.on_warning) options_.on_warning(line);
}

void Session::note(const std::vector<std::string>& lines) {
  warnings_.insert(warnings_.end(), lines.begin(), lines.end());
}

bool Session::run_stages(StageRunner& stages, std::size_t end) const {
  return run::run_stages(
      stages, end, [this] { return proceeds(); },
      [this](double share, const std::string& stage) { report(share, stage); });
}

Error Session::stopped_before(const std::string& what) const {
  return Error(fmt::format("{}: interrupted before {}, and nothing was written; run the same command again",
                           plan_.source.string(), what),
               ExitStatus::interrupted);
}

void Session::keep(State state, double time) {
  transfer(StateTransfer::saving_to(state).below(kind_.group));
  kept_ = std::move(state);
  const bool first = std::exchange(first_state_, false);
  if (!is_state_due(time) && !(first && cadence_.is_on())) return;
  cadence_.restart(wall_time(), time);
  const auto report_once = [&](const std::string& problem) {
    if (!std::exchange(state_failed_, true)) warn(fmt::format("no state at t = {:g} s: {}", time, problem));
  };
  try {
    write_kept_state();
    state_failed_ = false;
  } catch (const Error& error) {
    report_once(error.what());
  } catch (const std::bad_alloc&) {
    report_once("there is no memory for it; use fewer bodies, or checkpoint.every = \"never\"");
  }
}

void Session::write_kept_state() {
  if (!kept_) return;
  state_file::write_state(directory_.add(kind_.state), *kept_);
  kept_.reset();
}

void Session::transfer(const StateTransfer& state) {
  std::string scenario = plan_.resolved_text;
  state.value("scenario", "", scenario);
  study_->transfer(state);
  transfer_notes(state);
  double wall_time = this->wall_time();
  if (!state.has("wall")) return;
  state.value("wall", "s", wall_time, stored::non_negative);
  if (state.restoring()) wall_time_before_ = wall_time;
}

void Session::transfer_notes(const StateTransfer& state) {
  state.rows("warnings", "", warnings_);
  const InputHashes inputs = transfer_inputs(state.below("inputs"), inputs_);
  if (state.restoring())
    inputs_ = inputs_after(inputs, inputs_, [this](const std::string& line) { warn(line); });
}

void SpareRoom::reserve(const RunDirectory& directory, const char* record) {
  path_ = directory.add(file_name);
  std::error_code failed;  // without a record none is kept for it
  const std::uintmax_t present = std::filesystem::file_size(directory.path() / record, failed);
  file_ = files::create_file(path_.c_str());
  if (!file_.is_open()) throw_unwritable(path_, errno);
  const int code = posix_fallocate(file_.get(), 0, off_t(size + (failed ? 0 : present)));
  if (code == ENOSPC || code == EDQUOT) throw_unwritable(path_, code);
}

void SpareRoom::release() {
  if (file_.is_open() && files::is_at(file_, path_.c_str())) unlink(path_.c_str());
  file_ = files::Descriptor();
}

}  // namespace scree::run
