#include "field_output.hpp"

#include "sampler.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/fields/field_input.hpp>
#include <scree/files/text_file.hpp>

namespace scree::run {

namespace {

std::string frame_name(const std::string& fields, std::uint64_t step) {
  return fmt::format("{}_{:010}.vti", fields, step);
}

// The bodies at the start of a run, from which the grid follows, also in a run that goes on.
fields::FieldInput input_at_start(const Simulation& s) {
  fields::FieldInput input = {.dimension = s.dimension(), .domain = s.domain()};
  for (const Body& body : s.scene().bodies)
    input.bodies.push_back({.id = body.id, .radius = body.radius, .position = body.position});
  std::sort(input.bodies.begin(), input.bodies.end(),
            [](const fields::FieldBody& a, const fields::FieldBody& b) { return a.id < b.id; });
  return input;
}

}  // namespace

FieldOutput::FieldOutput(const scenario::Plan& plan, const RunDirectory& directory, unsigned threads)
    : directory_(directory), threads_(threads), dimension_(plan.scene.dimension) {
  for (const scenario::FieldsPlan& fields : plan.fields) all_.push_back({.plan = &fields});
  if (!all_.empty()) recorder_ = &fields::load_recorder();
}

void FieldOutput::prepare(const Simulation& simulation) {
  if (all_.empty()) return;
  const fields::FieldInput input = input_at_start(simulation);
  for (Recorded& recorded : all_) {
    try {
      recorded.setting = recorder_->setting(recorded.plan->request, input);
    } catch (const Error& error) {
      throw error.at(recorded.plan->place);
    }
  }
}

std::uint64_t FieldOutput::take(const Simulation& s, const std::string& stage, std::uint64_t steps) {
  for (Recorded& recorded : all_)
    if (recorded.plan->is_of(stage) && is_due(steps, recorded.plan->every, s.step_length()))
      write(recorded, s);
  return next(s, stage, steps);
}

std::uint64_t FieldOutput::next(const Simulation& s, const std::string& stage, std::uint64_t steps) const {
  std::uint64_t first = never;
  for (const Recorded& recorded : all_)
    if (recorded.plan->is_of(stage))
      first = std::min(first, next_due(steps, recorded.plan->every, s.step_length()));
  return first;
}

void FieldOutput::take_last(const Simulation& s, const std::string& stage) {
  for (Recorded& recorded : all_)
    if (recorded.plan->is_of(stage)) write(recorded, s);
}

std::filesystem::path FieldOutput::listed(const std::string& file) const {
  const std::filesystem::path path = directory_.add("fields/" + file);
  std::error_code failed;  // a failure is reported when the file is opened
  std::filesystem::create_directories(path.parent_path(), failed);
  return path;
}

void FieldOutput::write(Recorded& recorded, const Simulation& s) {
  if (!recorded.steps.empty() && recorded.steps.back() == s.steps()) return;
  const fields::FieldInput input = fields::input_of(s);
  if (recorded.plan->table) {
    if (!recorded.table) {
      recorded.table = std::make_unique<LineFile>(listed(recorded.plan->name + ".csv"));
      recorded.table->add(recorder_->csv_header(dimension_));
    }
    recorded.table->add(recorder_->csv_rows(*recorded.setting, input, threads_));
  } else {
    files::write_atomically(listed(frame_name(recorded.plan->name, s.steps())),
                            recorder_->vti(*recorded.setting, input, threads_));
  }
  recorded.times.push_back(s.time());
  recorded.steps.push_back(s.steps());
  if (!recorded.plan->table) write_collection(recorded);
}

void FieldOutput::write_collection(const Recorded& recorded) const {
  std::vector<fields::TimedFile> files;
  for (std::size_t k = 0; k < recorded.steps.size(); ++k)
    files.push_back({recorded.times[k], frame_name(recorded.plan->name, recorded.steps[k])});
  files::write_atomically(listed(recorded.plan->name + ".pvd"), recorder_->pvd(files));
}

void FieldOutput::transfer(const StateTransfer& state) {
  for (Recorded& recorded : all_) {
    const StateTransfer of = state.below(recorded.plan->name);
    of.rows("times", "s", recorded.times);
    of.rows("steps", "1", recorded.steps);
    if (recorded.times.size() != recorded.steps.size()) of.refuse("steps", "are not as many as the times");
    if (!recorded.plan->table) continue;
    std::uint64_t bytes = recorded.table ? recorded.table->bytes() : 0;
    of.value("bytes", "1", bytes);
    if (state.restoring() && bytes > 0)
      recorded.table =
          std::make_unique<LineFile>(directory_.path() / "fields" / (recorded.plan->name + ".csv"), bytes);
  }
}

void FieldOutput::cut() {
  for (Recorded& recorded : all_)
    if (recorded.table)
      recorded.table->cut();
    else if (!recorded.steps.empty() && !recorded.plan->table)
      write_collection(recorded);
}

void FieldOutput::flush() {
  for (Recorded& recorded : all_)
    if (recorded.table) recorded.table->flush();
}

}  // namespace scree::run
