#include "load_study.hpp"

#include <scree/files/place_error.hpp>
#include <scree/run/unfinished.hpp>
#include <scree/state_transfer.hpp>

// Loads that go on from the state of an interrupted one.

namespace scree::quasi_static {

namespace {

void transfer_hand_overs(const StateTransfer& state, std::vector<HandOver>& all) {
  std::vector<double> from, to;
  for (const HandOver& h : all) from.push_back(h.from), to.push_back(h.to);
  state.rows("from", "s", from);
  to.resize(from.size());
  state.sized_rows("to", "s", to);
  all.resize(from.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = {from[k], to[k]};
}

void transfer_count(const StateTransfer& state, const char* name, std::size_t& number) {
  std::uint64_t stored = number;
  state.value(name, "1", stored);
  number = std::size_t(stored);
}

}  // namespace

void LoadStudy::transfer(const StateTransfer& state) {
  transfer_count(state, "intervals_done", interval_);
  transfer_count(state, "intervals_between_states", intervals_in_part_);
  state.value("series_bytes", "1", series_bytes_);
  for (const auto& [name, time] : {std::pair{"start", &load_.start},
                                   {"end", &load_.end},
                                   {"reached", &load_.reached},
                                   {"increment", &load_.increment},
                                   {"period", &load_.period},
                                   {"dynamic_wall", &load_.dynamic_wall_time}})
    state.value(name, "s", *time);
  for (const auto& [name, number] : {std::pair{"bodies", &load_.bodies},
                                     {"degrees_of_freedom", &load_.degrees_of_freedom},
                                     {"increments", &load_.increments},
                                     {"iterations", &load_.iterations},
                                     {"events", &load_.events},
                                     {"dynamic_steps", &load_.dynamic_steps}})
    transfer_count(state, name, *number);
  transfer_hand_overs(state.below("hand_overs"), load_.hand_overs);
  state.rows("lengths_at_start", "m", lengths_at_start_);
  state.rows("times", "s", times_);
  charted_.resize(times_.size());
  state.sized_rows("charted", "1", charted_, 1, stored::any);  // NaN: there is nothing to show
  charted_forces_.resize(times_.size());
  state.sized_rows("charted_forces", "N", charted_forces_, 1, stored::any);
  surfaces_.transfer(state.below("surfaces"));
  if (bool moves = packing_.moves(); moves && !state.restoring()) state.value("moves", "1", moves);
}

// Intervals are counted, and a packing that moves was handed over.
void LoadStudy::check_restored(const StateTransfer& state) const {
  constexpr double most_intervals = 1e9;
  if (intervals_in_part_ == 0) state.refuse("intervals_between_states", "is 0");
  if (!(load_.increment > 0 && load_.end > load_.start &&
        (load_.end - load_.start) / load_.increment < most_intervals))
    state.refuse("increment", "does not divide the time from 'start' to 'end'");
  if (interval_ > intervals()) state.refuse("intervals_done", "is larger than the number of intervals");
  if (state.has("moves") && load_.hand_overs.empty()) state.refuse("hand_overs/from", "has none");
  if (lengths_at_start_.size() > std::size_t(plan_.scene.dimension))
    state.refuse("lengths_at_start", "has a length for more axes than the scene has");
}

void LoadStudy::restore(const State& state) {
  check_plan();
  const StateTransfer from = StateTransfer::restoring_from(state).below(run::quasi_static_results.group);
  session_.transfer(from);
  check_restored(from);
  packing_.begin(state, from.has("moves"));
  surfaces_.restore(from.below("surfaces"), packing_.surface_names());
  box_.emplace(lengths_at_start_, surfaces_);
  series_.emplace(session_.directory().path() / series_file, series_bytes_);
}

FollowedLoad resume_following(const FollowOptions& options, PluginHost& host) {
  return files::in_place([&] {
    run::Unfinished from =
        run::unfinished_in(options.out, run::quasi_static_results, host, options.on_warning);
    run::Session session(run::quasi_static_results, from.plan, run::session_options(options),
                         std::move(from.directory));
    LoadStudy study(from.plan, options, session);
    session.resume(study, from.state, from.file);
    return study.result();
  });
}

}  // namespace scree::quasi_static
