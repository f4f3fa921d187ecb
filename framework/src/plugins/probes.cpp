#include "plugins/guarded_numbers.hpp"
#include "plugins/plugin_call.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/probes.hpp>

namespace scree {

namespace {

// Names and units become the header of a CSV file, "name [unit],...".
bool fits_csv(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](unsigned char c) {
    return c < 0x20 || c == 0x7f || c == ',' || c == '"' || c == '[' || c == ']';
  });
}

}  // namespace

Probe::Probe(const Parameters& parameters, int dimension, std::vector<std::uint8_t> left_out)
    : plugin_(parameters, dimension, no_bounds, no_bounds), left_out_(std::move(left_out)) {
  static std::atomic<std::uint64_t> probes = 0;
  number_ = probes++;
  const char* const plugin = parameters.plugin().name;
  if (observes() && !plugin_.interface().observe)
    throw Error(fmt::format("plug-in {}: asks to observe but has no observe function; give it one", plugin));
  if (!(observe_every() >= 0 && std::isfinite(observe_every())))
    throw Error(fmt::format("plug-in {}: observes every {} s; give a time above 0, or 0 for the scenario's",
                            plugin, observe_every()));
  check_totals();
  is_listed_ = has_totals();
  if (has_totals()) listed_.emplace();
  std::set<std::string> taken;
  for (std::uint32_t c = 0; c < plugin_.instance().column_count; ++c) {
    char name[SCREE_MAX_NAME] = "", unit[SCREE_MAX_NAME] = "";
    plugin_call(plugin_.parameters().plugin().name, "column",
                [&] { plugin_.interface().column(plugin_.storage(), c, name, unit); });
    name[SCREE_MAX_NAME - 1] = unit[SCREE_MAX_NAME - 1] = 0;
    names_.push_back(name);
    units_.push_back(unit);
    if (names_.back().empty() || !fits_csv(names_.back()) || !fits_csv(units_.back()))
      throw Error(
          fmt::format("plug-in {}: the name or unit of column {} is empty or has characters that a "
                      "CSV file cannot hold; name columns in snake_case",
                      plugin, c + 1));
    if (names_.back() == "time" || names_.back() == "stage")
      throw Error(fmt::format("plug-in {}: a column is named '{}', as one that every series has; rename it",
                              plugin, names_.back()));
    if (!taken.insert(names_.back()).second)
      throw Error(
          fmt::format("plug-in {}: two columns are named '{}'; list every body, pair, wall or surface once",
                      plugin, names_.back()));
  }
}

std::vector<std::string> Probe::meanings() const {
  const scree_probe& interface = plugin_.interface();
  std::vector<std::string> meanings(names_.size());
  if (interface.struct_size <= offsetof(scree_probe, meaning) || !interface.meaning) return meanings;
  for (std::uint32_t c = 0; c < meanings.size(); ++c) {
    char text[SCREE_MAX_MEANING] = "";
    plugin_call(plugin_.parameters().plugin().name, "meaning",
                [&] { interface.meaning(plugin_.storage(), c, text); });
    text[SCREE_MAX_MEANING - 1] = 0;
    meanings[c] = text;
  }
  return meanings;
}

namespace {

// Most numbers of a state: 8 GB.
constexpr std::uint64_t max_state = 1'000'000'000;

}  // namespace

template <class Call>
auto Probe::show(const scree_view& view, std::span<const double> inputs, const Call& call) const {
  if (inputs.empty() && left_out_.empty()) return call(view);
  scree_view shown = view;
  shown.input_count = std::uint32_t(inputs.size());
  shown.inputs = inputs.data();
  if (!left_out_.empty()) shown.left_out = left_out_.data();
  return call(shown);
}

std::uint64_t Probe::size_in(const scree_view& view) const {
  const scree_probe& interface = plugin_.interface();
  if (!interface.state_size) return plugin_.instance().state_width;
  return show(view, {}, [&](const scree_view& shown) {
    return plugin_call(plugin_.parameters().plugin().name, "state_size",
                       [&] { return interface.state_size(plugin_.storage(), &shown); });
  });
}

std::vector<double> Probe::started(const scree_view& view) const {
  const scree_probe& interface = plugin_.interface();
  const char* name = plugin_.parameters().plugin().name;
  const std::uint64_t size = size_in(view);
  if (size > max_state)
    throw Error(fmt::format("plug-in {}: its state of {} numbers is larger than the limit of {}; keep less",
                            name, size, max_state));
  std::vector<double> state = guarded(size);
  char message[512] = "";
  const int failed = show(view, {}, [&](const scree_view& shown) {
    return plugin_call(name, "start", [&] {
      return interface.start(plugin_.storage(), &shown, state.data(), message, sizeof(message));
    });
  });
  message[sizeof(message) - 1] = 0;
  if (failed) throw Error(fmt::format("probe {}: {}", name, message));
  check_guard(state, name, "state");
  return state;
}

void Probe::start_once(const scree_view& view) {
  if (!is_started_) {
    state_ = started(view);
    state_size_ = state_.size() - guard_size;
    is_started_ = true;
  }
  if (!is_listed_) listed_ = marked(view, state_);
  is_listed_ = true;
}

ListedBodies Probe::marked(const scree_view& view, const std::vector<double>& state) const {
  const scree_probe& interface = plugin_.interface();
  const bool can_mark = interface.struct_size > offsetof(scree_probe, mark_bodies) && interface.mark_bodies;
  if (!can_mark || (needs() & SCREE_NEEDS_CONTACTS)) return {};
  std::vector<std::uint8_t> marks(view.body_count, 0);
  plugin_call(plugin_.parameters().plugin().name, "mark_bodies",
              [&] { interface.mark_bodies(plugin_.storage(), &view, state.data(), marks.data()); });
  if (std::find(marks.begin(), marks.end(), 0) == marks.end()) return {};
  ListedBodies listed(std::in_place);
  for (std::uint32_t i = 0; i < marks.size(); ++i)
    if (marks[i]) listed->push_back(i);
  return listed;
}

std::size_t Probe::check(const scree_view& view) const {
  const std::vector<double> state = started(view);
  if (has_totals() || (needs() & SCREE_NEEDS_NO_BODIES)) return 0;
  const ListedBodies listed = marked(view, state);
  return listed ? listed->size() : view.body_count;
}

void Probe::check_restored(const scree_view& view) const {
  if (const std::uint64_t size = size_in(view); is_started_ && state_size_ != size)
    throw Error(
        fmt::format("plug-in {}: its state has {} instead of {}; take a state that scree has written "
                    "for this scene",
                    plugin_.parameters().plugin().name, counted(state_size_, "number"), size));
}

void Probe::observe(const scree_view& view, std::span<const double> inputs) {
  start_once(view);
  if (!observes()) return;
  const char* const name = plugin_.parameters().plugin().name;
  show(view, inputs, [&](const scree_view& shown) {
    plugin_call(name, "observe",
                [&] { plugin_.interface().observe(plugin_.storage(), &shown, state_.data()); });
  });
  check_guard(state_, name, "state");
}

namespace {

// Bodies and contacts that a probe reads in their parts alone.
scree_view without_bodies(scree_view view) {
  view.body_count = view.contact_count = 0;
  for (auto* const vectors : {&view.position, &view.velocity, &view.spin, &view.force, &view.torque})
    for (scree_column& column : *vectors) column = {};
  for (scree_column& column : view.orientation) column = {};
  for (const std::int32_t*& image : view.image) image = nullptr;
  view.radius = view.mass = view.inertia = {};
  view.id = nullptr;
  view.material = nullptr;
  view.fixed = view.held = nullptr;
  return view;
}

}  // namespace

std::vector<double> Probe::sample(const scree_view& view, std::span<const double> inputs,
                                  const Totals& totals) {
  start_once(view);
  std::vector<double> added;
  if (has_totals()) added = totals ? totals() : totals_in(view);
  std::vector<double> row = guarded(plugin_.instance().column_count);
  const char* const name = plugin_.parameters().plugin().name;
  scree_view with_totals = has_totals() ? without_bodies(view) : view;
  with_totals.totals = added.data();
  show(with_totals, inputs, [&](const scree_view& shown) {
    plugin_call(name, "sample",
                [&] { plugin_.interface().sample(plugin_.storage(), &shown, state_.data(), row.data()); });
  });
  check_guard(row, name, "row");
  row.resize(row.size() - guard_size);
  return row;
}

void Probe::transfer(const StateTransfer& state) {
  std::vector<double> kept(state_.begin(), state_.begin() + std::ptrdiff_t(state_size_));
  state.value("is_started", "", is_started_);
  state.rows("state", "1", kept, 1, stored::any);
  if (!state.restoring() || !is_started_) return;
  state_size_ = kept.size();
  state_ = guarded(state_size_);
  std::copy(kept.begin(), kept.end(), state_.begin());
}

}  // namespace scree
