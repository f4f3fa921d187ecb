#include "particles_keys.hpp"
#include "readers.hpp"

#include <cmath>

#include <fmt/format.h>

#include <scree/files/text.hpp>
#include <scree/packing/random_cloud.hpp>

namespace scree::scenario {

namespace {

packing::Bounds read_box(const document::Table& region, int dimension) {
  packing::Bounds box;
  const Key* const keys[] = {&region_keys.x, &region_keys.y, &region_keys.z};
  for (int k = 0; k < dimension; ++k) {
    const std::vector<double> limits = region.numbers(*keys[k], 2);
    if (!(limits[0] < limits[1]))
      throw region.error(*keys[k], fmt::format("{:g} is not below {:g}", limits[0], limits[1]),
                         "give the lower limit first");
    box.lower[k] = limits[0];
    box.upper[k] = limits[1];
  }
  return box;
}

}  // namespace

packing::Region read_region(const document::Table& region, int dimension) {
  const std::string kind = read(region, region_keys.kind);
  if (kind == "box") return read_box(region, dimension);
  const Vec3 centre = read_vector(region, region_keys.centre, dimension, true);
  const double radius = read(region, region_keys.radius);
  if (kind == "sphere") return packing::Ball{centre, radius};
  if (dimension == 2)
    throw region.error(region_keys.kind, "a cylinder needs three dimensions",
                       "give kind = \"sphere\" for a circle");
  const std::string axis = read(region, region_keys.axis);
  return packing::Cylinder{centre, radius, read(region, region_keys.length), axis[0] - 'x'};
}

namespace {

std::array<bool, 3> read_axes(const document::Table& random, const packing::Region& region, int dimension) {
  std::array<bool, 3> periodic = {};
  const std::string axes = read(random, random_keys.periodic);
  for (const char axis : axes) {
    const int k = axis - 'x';
    if (k < 0 || k >= dimension)
      throw random.error(
          random_keys.periodic, fmt::format("'{}' is not a list of axes", files::one_line(axes)),
          dimension == 2 ? "give \"x\", \"y\" or \"xy\"" : "give \"xz\" or others of x, y and z");
    periodic[std::size_t(k)] = true;
  }
  if (!axes.empty() && !std::holds_alternative<packing::Bounds>(region))
    throw random.error(random_keys.periodic, "only a box is periodic", "remove it, or give a box as region");
  return periodic;
}

packing::CloudOptions read_options(const document::Table& particles, int dimension) {
  const document::Table random = particles.table(particles_keys.random);
  packing::CloudOptions options;
  options.dimension = dimension;
  options.region = read_region(particles.table(particles_keys.region), dimension);
  options.periodic = read_axes(random, options.region, dimension);
  options.solid_fraction = read_optional(random, random_keys.solid_fraction);
  options.growth = read(random, random_keys.growth);
  options.count = random.optional_integer(random_keys.count, random_keys.count.range);
  if (options.count.has_value() == options.solid_fraction.has_value())
    throw random.error(
        fmt::format("{} of count and solid_fraction is given", options.count ? "each" : "none"),
        "give one of them");
  if (options.solid_fraction == 0.0)
    throw random.error(random_keys.solid_fraction, "a solid fraction of 0 has no bodies", "give one above 0");
  return options;
}

}  // namespace

packing::Packing read_random_bodies(const document::Table& particles, int dimension, packing::Random& random,
                                    std::vector<Sphere> others, std::string& origin) {
  const packing::RadiusDistribution radii = read_radius(particles);
  packing::CloudOptions options = read_options(particles, dimension);
  options.obstacles = std::move(others);
  return placed(particles, particles_keys.random, [&] {
    check_body_memory(particles, particles_keys.random, packing::expected_count(options, radii, random));
    packing::Cloud cloud = packing::fill_randomly(options, radii, random);
    origin = fmt::format("at random, solid fraction {:.6g}", cloud.solid_fraction);
    if (options.solid_fraction) origin += fmt::format(" (radii times {:.6g})", cloud.radius_factor);
    return std::move(cloud.packing);
  });
}

}  // namespace scree::scenario
