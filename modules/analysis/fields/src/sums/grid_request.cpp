#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scree/available_memory.hpp>
#include <scree/error.hpp>
#include <scree/fields/field_sums.hpp>
#include <scree/fields/grid_request.hpp>

namespace scree::fields {

namespace {

constexpr double most_points_per_body = 1e6;
constexpr double most_periods = 100;  // between a grid and the scene; each is an image to look through

struct Extent {
  double lower, upper;  // (m)
};

Extent extent_of(const FieldInput& input, int k) {
  if (input.domain.periodic[std::size_t(k)]) return {input.domain.lower[k], input.domain.upper[k]};
  Extent extent = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const FieldBody& body : input.bodies) {
    extent.lower = std::min(extent.lower, body.position[k] - body.radius);
    extent.upper = std::max(extent.upper, body.position[k] + body.radius);
  }
  return extent;
}

void check_size(const FieldGrid& grid, double cells, double width) {
  const double bytes = 2 * cells * double(sizeof(FieldPoint));  // sums and means
  if (const double there = available_memory(); bytes > there)
    throw Error("spacing",
                fmt::format("gives {:.3g} points, which take {:.3g} GB of memory", cells, bytes / 1e9),
                fmt::format("give a larger one, or a smaller box: there are {:.3g} GB", there / 1e9));
  double near = 1;
  for (int k = 0; k < grid.dimension; ++k) {
    const bool periodic = grid.period[k] > 0;
    double points = grid.count[std::size_t(k)] > 1 ? 2 * width / grid.spacing[k] : 1;
    if (periodic) points = std::max(points, 2 * width / grid.period[k]);  // images of a layer
    near *= std::max(1.0, points);
  }
  const double volume = std::pow(width, grid.dimension);
  if (!(volume > 0 && std::isfinite(volume)))
    throw Error("width",
                fmt::format("is {:g} m, of which the kernel is {} in the numbers of a computer", width,
                            volume > 0 ? "0" : "infinite"),
                "give one near the size of the bodies");
  if (near > most_points_per_body)
    throw Error("width", fmt::format("is so large that each body adds to {:.3g} points", near),
                "give a smaller one, or a larger spacing");
}

void check_periods(const FieldInput& input, int k, double from, double to) {
  if (!input.domain.periodic[std::size_t(k)]) return;
  const double room = most_periods * input.domain.length(k);
  if (!(from > input.domain.lower[k] - room && to < input.domain.upper[k] + room))
    throw Error("plane",
                fmt::format("the grid is more than {:g} periods away along {}", most_periods, "xyz"[k]),
                "give a plane, lower and upper near the scene");
}

// (m) Two mean diameters.
double default_width(const FieldInput& input) {
  if (input.bodies.empty()) throw Error("", "the state has no bodies", "give a state with bodies");
  double sum = 0;
  for (const FieldBody& body : input.bodies) sum += body.radius;
  return 4 * sum / double(input.bodies.size());
}

double width_for(const GridRequest& request, const FieldInput& input) {
  return request.width > 0 ? request.width : default_width(input);
}

}  // namespace

AveragingKernel kernel_for(const GridRequest& request, const FieldInput& input) {
  return {input.dimension, width_for(request, input), request.shape};
}

FieldGrid grid_for(const GridRequest& request, const FieldInput& input) {
  const double width = width_for(request, input);
  const double spacing = request.spacing > 0 ? request.spacing : 0.5 * width;
  FieldGrid grid;
  grid.dimension = input.dimension;
  double cells = 1;
  for (int k = 0; k < input.dimension; ++k) {
    if (input.domain.periodic[std::size_t(k)]) grid.period[k] = input.domain.length(k);
    grid.spacing[k] = spacing;
    if (k == request.plane_axis) {
      check_periods(input, k, request.plane, request.plane);
      grid.first[k] = request.plane;
      continue;
    }
    Extent extent = extent_of(input, k);
    if (request.lower) extent.lower = (*request.lower)[k];
    if (request.upper) extent.upper = (*request.upper)[k];
    const double length = extent.upper - extent.lower;
    if (!(length > 0))
      throw Error("upper",
                  fmt::format("is not above the lower end along {} ({:g} m)", "xyz"[k], extent.lower),
                  "give a box with a volume");
    check_periods(input, k, extent.lower, extent.upper);
    const double count = std::max(1.0, std::round(length / spacing));
    cells *= count;
    grid.spacing[k] = length / count;
    grid.first[k] = extent.lower + 0.5 * grid.spacing[k];
    grid.count[std::size_t(k)] = std::size_t(std::min(count, 1e12));
  }
  check_size(grid, cells, width);
  return grid;
}

}  // namespace scree::fields
