#include "course_files.hpp"
#include "follower.hpp"
#include "load_warnings.hpp"

#include <utility>

#include <fmt/format.h>

#include <scree/files/try_each.hpp>
#include <scree/run/input_hashes.hpp>
#include <scree/state_file/state_file.hpp>

namespace scree::quasi_static {

namespace {

constexpr double seconds_between_states = 60;

void transfer_hand_overs(const StateTransfer& state, std::vector<HandOver>& all) {
  std::vector<double> from, to;
  for (const HandOver& h : all) from.push_back(h.from), to.push_back(h.to);
  state.rows("from", "s", from);
  to.resize(from.size());
  state.sized_rows("to", "s", to);
  all.resize(from.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = {from[k], to[k]};
}

void transfer_counts(const StateTransfer& state, Course& course) {
  const auto count = [&](const char* name, std::size_t& number) {
    std::uint64_t stored = number;
    state.value(name, "1", stored);
    number = stored;
  };
  count("bodies", course.bodies);
  count("degrees_of_freedom", course.degrees_of_freedom);
  count("increments", course.increments);
  count("iterations", course.iterations);
  count("events", course.events);
  count("dynamic_steps", course.dynamic_steps);
}

}  // namespace

// Written now and then, and when the course ends early.
void Follower::keep_state(State state) {
  series_bytes_ = series_->bytes();
  const StateTransfer to = StateTransfer::saving_to(state).below(results.group);
  transfer_state(to);
  if (bool moves = bool(dynamics_)) to.value("moves", "1", moves);
  kept_ = std::move(state);
  if (interval_ > 0 && seconds() - last_state_ < seconds_between_states) return;
  last_state_ = seconds();
  write_kept_state();
}

void Follower::write_kept_state() {
  if (kept_) state_file::write_state(directory_.add(results.state), *kept_);
}

void Follower::transfer_state(const StateTransfer& state) {
  std::string scenario = plan_.resolved_text;
  state.value("scenario", "", scenario);
  const auto number = [&](const char* name, std::uint64_t now) {
    state.value(name, "1", now);
    return now;
  };
  interval_ = std::size_t(number("intervals_done", interval_));
  between_states_ = std::size_t(number("intervals_between_states", between_states_));
  series_bytes_ = number("series_bytes", series_bytes_);
  if (between_states_ == 0) state.refuse("intervals_between_states", "is 0");
  for (const auto& [name, time] : {std::pair{"start", &course_.start},
                                   {"end", &course_.end},
                                   {"reached", &course_.reached},
                                   {"increment", &course_.increment},
                                   {"period", &course_.period},
                                   {"dynamic_wall", &course_.dynamic_wall}})
    state.value(name, "s", *time);
  double wall = seconds();
  state.value("wall", "s", wall, stored::non_negative);
  transfer_counts(state, course_);
  transfer_hand_overs(state.below("hand_overs"), course_.hand_overs);
  state.rows("lengths_at_start", "m", lengths_at_start_);
  state.rows("times", "s", times_);
  strains_.resize(times_.size());
  state.sized_rows("strains", "1", strains_, 1, stored::any);  // NaN: the box is not known along x and y
  state.rows("warnings", "", course_.warnings);
  const run::InputHashes inputs = run::transfer_inputs(state.below("inputs"), course_.inputs);
  if (!state.restoring()) return;
  check_restored(state);
  course_.inputs = run::inputs_after(inputs, course_.inputs, [this](const std::string& line) { warn(line); });
  box_ = std::make_unique<BoxRow>(lengths_at_start_);
  wall_before_ = last_state_ = wall;
}

// Intervals are counted, and a packing that moves was handed over.
void Follower::check_restored(const StateTransfer& state) const {
  constexpr double most_intervals = 1e9;
  if (!(course_.increment > 0 && course_.end > course_.start &&
        (course_.end - course_.start) / course_.increment < most_intervals))
    state.refuse("increment", "does not divide the time from 'start' to 'end'");
  if (interval_ > intervals()) state.refuse("intervals_done", "is larger than the number of intervals");
  if (state.has("moves") && course_.hand_overs.empty()) state.refuse("hand_overs/from", "has none");
  if (lengths_at_start_.size() > std::size_t(plan_.scene.dimension))
    state.refuse("lengths_at_start", "has a length for more axes than the scene has");
}

void Follower::write_final_state() {
  const State state = packing_ ? packing_->state() : dynamics_->state();
  state_file::write_state(directory_.add("final_state.h5"), state);
}

void Follower::end_course() {
  end_packing();
  course_.wall = seconds();
  if (const std::string warning = dynamics_warning(course_); !warning.empty()) warn(warning);
}

// The record first, for which room was kept.
void Follower::save_failed() {
  end_course();
  room_.release();
  files::try_each([&] { write_record("failed", course_, directory_); }, [&] { write_kept_state(); },
                  [&] { draw_chart(course_, times_, strains_, directory_); });
}

void Follower::save(const std::string& status) {
  if (status == "finished") write_final_state();
  end_course();
  if (status != "finished") write_kept_state();
  try {
    draw_chart(course_, times_, strains_, directory_);
  } catch (const std::exception& error) {
    warn(fmt::format("the chart was not drawn: {}", error.what()));
  }
  room_.release();
  write_record(status, course_, directory_);
  if (status != "finished") return;
  std::error_code failed;  // of no use any more, and replaced by the next course
  std::filesystem::remove(directory_.path() / results.state, failed);
}

}  // namespace scree::quasi_static
