#include <algorithm>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include <scree/plugin/program.hpp>
#include <scree/scenario/drive_sampling.hpp>

namespace scree::scenario {

namespace {

// Highest frequency (Hz) of a function of time, by the layout of program.hpp; 0 if it has none.
double highest_hz(std::span<const double> data) {
  switch (Program::Kind(int(data[0]))) {
    case Program::sine:
      return data[3];
    case Program::cycle:
      return 1 / data[3];
    case Program::drive:
    case Program::ricker:
      return data[4];
    case Program::chirp:
      return std::max(data[4], data[5]);
    case Program::gaussian:  // standard deviation of its spectrum
      return 1 / (2 * std::numbers::pi * data[4]);
    case Program::noise:
      return data[4] + data[5] * double(data.size() - 7);
    case Program::sweep: {
      double highest = 0;
      for (std::size_t k = 5; k < data.size(); k += 2) highest = std::max(highest, data[k]);
      return highest;
    }
    default:
      return 0;
  }
}

void add(const std::string& name, const char* key, std::span<const double> program, double step,
         std::vector<std::string>& lines) {
  const auto problem = sampling_problem(highest_hz(program), step);
  if (!problem) return;
  const std::string line =
      fmt::format("'{}' of '{}': {}; give a lower frequency, or a shorter time.step", key, name, *problem);
  if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
}

void add(const BodyGroup& group, double step, std::vector<std::string>& lines) {
  const auto add_all = [&](const BodyGroup::Programs& programs, const char* translation,
                           const char* rotation) {
    for (int k = 0; k < freedom::count; ++k)
      if (const std::vector<double>& program = programs[std::size_t(k)]; !program.empty())
        add(group.name, k < freedom::first_rotation ? translation : rotation, program, step, lines);
  };
  add_all(group.velocity, "velocity", "spin");
  add_all(group.displacement, "displacement", "displacement");
  add_all(group.load, "force", "torque");
}

void add(const std::string& name, const Parameters& parameters, double step,
         std::vector<std::string>& lines) {
  const std::vector<scree_value> values = parameters.values();
  for (std::uint32_t k = 0; k < parameters.plugin().parameter_count; ++k) {
    const scree_parameter& p = parameters.plugin().parameters[k];
    if (p.type == SCREE_PROGRAM && parameters.given(p.key))
      add(name, p.key, {values[k].data, values[k].count}, step, lines);
  }
}

}  // namespace

std::optional<std::string> sampling_problem(double to_hz, double step) {
  if (to_hz * step < 0.5) return std::nullopt;
  return fmt::format("{:g} Hz is not below half the sampling rate of a sample per step, {:g} Hz", to_hz,
                     0.5 / step);
}

std::vector<std::string> undersampled_drives(const Scene& scene, const std::vector<Stage>& stages) {
  std::vector<std::string> lines;
  for (const Scene::Boundary& boundary : scene.boundaries)
    add(boundary.name, boundary.parameters, scene.step, lines);
  for (const Scene::BodyForce& force : scene.body_forces)
    add(force.name, force.parameters, scene.step, lines);
  for (const BodyGroup& group : scene.groups) add(group, scene.step, lines);
  for (const Stage& stage : stages)
    for (const Stage::Change& change : stage.changes) add(change.name, change.parameters, scene.step, lines);
  return lines;
}

}  // namespace scree::scenario
