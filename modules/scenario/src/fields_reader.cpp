#include "output_keys.hpp"
#include "readers.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include <scree/scenario/names.hpp>

namespace scree::scenario {

namespace {

std::optional<Vec3> read_corner(const document::Table& t, const Key& key, int dimension) {
  if (!t.optional(key)) return std::nullopt;
  return read_vector(t, key, dimension, true);
}

void read_plane(const document::Table& t, int dimension, fields::GridRequest& request) {
  const std::optional<document::Table> plane = t.optional_table(fields_keys.plane);
  if (!plane) return;
  const std::string axes = dimension == 2 ? "xy" : "xyz";
  for (int k = 0; k < dimension; ++k) {
    const std::optional<double> place = plane->optional_number(axes.substr(std::size_t(k), 1));
    if (place && request.plane_axis >= 0)
      throw t.error(fields_keys.plane, "a plane is at one place on one axis", "give one axis");
    if (place) request.plane_axis = k, request.plane = *place;
  }
  plane->refuse_unused();
  if (request.plane_axis < 0)
    throw t.error(fields_keys.plane, "the plane has no axis",
                  fmt::format("give for example plane = {{ {} = 0.01 }}", axes.back()));
}

fields::GridRequest read_grid(const document::Table& t, int dimension) {
  fields::GridRequest request;
  const auto name = std::find(std::begin(fields::kernel_names), std::end(fields::kernel_names),
                              read(t, fields_keys.kernel));
  request.shape = fields::KernelShape(name - std::begin(fields::kernel_names));
  request.width = read_optional(t, fields_keys.width).value_or(0);
  request.spacing = read_optional(t, fields_keys.spacing).value_or(0);
  request.lower = read_corner(t, fields_keys.lower, dimension);
  request.upper = read_corner(t, fields_keys.upper, dimension);
  read_plane(t, dimension, request);
  return request;
}

}  // namespace

std::vector<FieldsPlan> read_fields(const document::Table& root, const Scene& scene,
                                    const std::vector<Stage>& stages) {
  std::vector<FieldsPlan> plans;
  std::vector<std::string> stage_names;
  for (const Stage& stage : stages) stage_names.push_back(stage.name);
  UniqueNames unique("fields");
  for (const document::Table& t : root.tables("fields")) {
    FieldsPlan plan;
    plan.name = read(t, fields_keys.name);
    check_file_name(t, plan.name);
    unique.add(t, plan.name);
    plan.every = read_interval(t, fields_keys.every, scene.step);
    plan.table = read(t, fields_keys.format) == "csv";
    plan.stages = read_stage_names(t, stage_names);
    plan.request = read_grid(t, scene.dimension);
    plan.place = t.place();
    plans.push_back(std::move(plan));
  }
  return plans;
}

}  // namespace scree::scenario
