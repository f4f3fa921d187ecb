#include "growth.hpp"
#include "sphere_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/packing/random_cloud.hpp>

namespace scree::packing {

namespace {

constexpr std::size_t drawn_at_once = 1000;

double total_volume(const std::vector<double>& radii, int dimension) {
  double sum = 0.0;
  for (const double radius : radii) sum += volume_of_body(radius, dimension);
  return sum;
}

double wanted_volume(const CloudOptions& options) {
  return *options.solid_fraction * volume_of(options.region, options.dimension);
}

void check_options(const CloudOptions& options, const RadiusDistribution& radii) {
  const Bounds box = bounds_of(options.region, options.dimension);
  for (int k = 0; k < options.dimension; ++k)
    if (!(box.lower[k] < box.upper[k]))
      throw Error("random cloud", fmt::format("the region has no length along {}", "xyz"[k]),
                  "give a lower and a larger upper limit");
  const double volume = volume_of(options.region, options.dimension);
  if (!std::isnormal(volume))
    throw Error("random cloud",
                fmt::format("the volume {} of the region is outside the range of numbers", volume),
                "check its lengths (m)");
  if (options.count.has_value() == options.solid_fraction.has_value())
    throw Error("random cloud", "there must be either a number of bodies or a solid fraction",
                "give one of the two");
  if (options.count && (*options.count < 1 || *options.count > max_cloud_bodies))
    throw Error("random cloud", fmt::format("{} bodies", *options.count),
                fmt::format("give 1 to {}", max_cloud_bodies));
  const auto* list = std::get_if<ListedRadius>(&radii);
  if (options.solid_fraction && list && list->weights.empty())
    throw Error("random cloud", "a list of radii in order has a number of bodies and no solid fraction",
                "give weights to draw the radii at random, or the number of bodies");
}

// As many radii as come nearest to a volume.
std::vector<double> radii_of_volume(double volume, const RadiusDistribution& distribution, int dimension,
                                    Random& random) {
  std::vector<double> radii, drawn;
  double sum = 0.0;
  for (std::size_t next = 0;; ++next) {
    if (next == drawn.size()) {
      drawn = draw_radii(distribution, drawn_at_once, random);
      next = 0;
    }
    const double with_it = sum + volume_of_body(drawn[next], dimension);
    if (!radii.empty() && with_it - volume > volume - sum) return radii;
    radii.push_back(drawn[next]);
    sum = with_it;
  }
}

// x^(1/dimension) for x near 1 by Newton's method, since std::cbrt differs between platforms in the last bit.
double root(double x, int dimension) {
  double y = 1.0;
  for (int k = 0; k < 100; ++k) y -= (dimension == 2 ? y - x / y : y - x / (y * y)) / dimension;
  return y;
}

// Multiplies radii so that their bodies have a volume. Returns the factor.
double scale_to(double volume, std::vector<double>& radii, int dimension) {
  constexpr double most = 0.05;
  const double factor = root(volume / total_volume(radii, dimension), dimension);
  if (!(std::abs(factor - 1.0) <= most))
    throw Error("random cloud",
                fmt::format("{} would have to be multiplied by {:.3g} to meet the solid fraction",
                            counted(radii.size(), "radius", "radii"), factor),
                "give smaller radii, a larger region, or the number of bodies");
  for (double& radius : radii) radius *= factor;
  return factor;
}

void require_size(const Bounds& box, int dimension, double smallest, double largest) {
  constexpr double least = 1e-9;  // so that cells can be counted, and rounding of coordinates is far smaller
  for (int k = 0; k < dimension; ++k) {
    const double length = box.upper[k] - box.lower[k];
    if (2.0 * largest > length)
      throw Error("random cloud",
                  fmt::format("a body of radius {:.6g} m does not fit into {:.6g} m along {}", largest,
                              length, "xyz"[k]),
                  "give a larger region or smaller radii");
    const double farthest = std::max(std::abs(box.lower[k]), std::abs(box.upper[k]));
    if (smallest < least * std::max(length, farthest))
      throw Error(
          "random cloud",
          fmt::format("a radius of {:.6g} m is below {:g} of the region along {}", smallest, least, "xyz"[k]),
          "check the units of radius and region (m)");
  }
}

// Places for the bodies of a cloud.
class Placement {
 public:
  Placement(const CloudOptions& options, const std::vector<double>& radii)
      : options_(options),
        radii_(radii),
        box_(bounds_of(options.region, options.dimension)),
        order_(radii.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return radii[a] > radii[b]; });
    require_size(box_, options.dimension, radii[order_.back()], radii[order_.front()]);
  }

  // Obstacles that reach into the region, in the domain.
  std::vector<Sphere> obstacles() const;
  std::vector<Vec3> find(Random& random, std::size_t& distances) const {
    SphereGrid grid = with_obstacles();
    std::vector<Vec3> places(radii_.size());
    double volume = 0.0;
    for (std::size_t n = 0; n < order_.size(); ++n) {
      const double radius = radii_[order_[n]];
      const std::optional<Vec3> place = free_place(grid, radius, random);
      if (!place) give_up(n, volume / volume_of(options_.region, options_.dimension));
      grid.add({*place, radius}, radius);
      places[order_[n]] = *place;
      volume += volume_of_body(radius, options_.dimension);
    }
    distances = grid.distances();
    return places;
  }

 private:
  SphereGrid with_obstacles() const;
  std::optional<Vec3> free_place(SphereGrid& grid, double radius, Random& random) const;
  [[noreturn]] void give_up(std::size_t placed, double reached) const;

  const CloudOptions& options_;
  const std::vector<double>& radii_;
  Bounds box_;
  std::vector<std::uint32_t> order_;  // of the bodies, the largest first
};

std::vector<Sphere> Placement::obstacles() const {
  Domain domain;
  domain.periodic = options_.periodic, domain.lower = box_.lower, domain.upper = box_.upper;
  std::vector<Sphere> near;
  for (Sphere sphere : options_.obstacles) {
    bool reaches = true;
    for (int k = 0; k < options_.dimension; ++k) {
      double& x = sphere.position[k];
      if (domain.periodic[std::size_t(k)])
        x -= std::floor((x - domain.lower[k]) / domain.length(k)) * domain.length(k);
      else
        reaches &= x + sphere.radius > box_.lower[k] && x - sphere.radius < box_.upper[k];
    }
    if (reaches) near.push_back(sphere);
  }
  return near;
}

SphereGrid Placement::with_obstacles() const {
  const double first = radii_[order_.front()];
  double largest = first;
  const std::vector<Sphere> near = obstacles();
  for (const Sphere& sphere : near) largest = std::max(largest, sphere.radius);
  SphereGrid grid(options_.dimension, {options_.periodic, box_.lower, box_.upper}, largest);
  for (const Sphere& sphere : near) grid.add(sphere, first);
  return grid;
}

std::optional<Vec3> Placement::free_place(SphereGrid& grid, double radius, Random& random) const {
  for (int tries = 0; tries < max_cloud_tries; ++tries) {
    Sphere sphere = {{}, radius};
    for (int k = 0; k < options_.dimension; ++k) {
      const double margin = options_.periodic[std::size_t(k)] ? 0.0 : radius;
      sphere.position[k] = random.uniform(box_.lower[k] + margin, box_.upper[k] - margin);
    }
    const bool inside = std::holds_alternative<Bounds>(options_.region) ||
                        holds(options_.region, options_.dimension, sphere.position, radius);
    if (inside && !grid.overlaps(sphere)) return sphere.position;
  }
  return std::nullopt;
}

void Placement::give_up(std::size_t placed, double reached) const {
  constexpr double sure = 0.95;  // of the solid fraction that another seed reaches too
  const std::string problem =
      fmt::format("after {} of {}, a solid fraction of {:.3g}, {} places in a row are taken", placed,
                  counted(radii_.size(), "body", "bodies"), reached, max_cloud_tries);
  const std::string less =
      placed == 0 ? "give a region that other bodies leave free"
      : options_.solid_fraction
          ? fmt::format("give a solid fraction of at most {:.2g}", sure * reached)
          : fmt::format("give at most {}", counted(std::size_t(sure * double(placed)) + 1, "body", "bodies"));
  throw Error(
      "random cloud", problem,
      less + (options_.growth
                  ? ", or a larger region"
                  : ", or a larger region, or growth = true, with which small bodies grow to their radii"));
}

// Solid fraction that bodies at random places reach easily.
double easy_fraction(int dimension) { return dimension == 2 ? 0.4 : 0.2; }

std::vector<Vec3> places_of(const CloudOptions& options, const std::vector<double>& radii, Random& random,
                            std::size_t& distances) {
  const double wanted = total_volume(radii, options.dimension) / volume_of(options.region, options.dimension);
  const double easy = easy_fraction(options.dimension);
  if (!options.growth || wanted <= easy) return Placement(options, radii).find(random, distances);
  const Bounds box = bounds_of(options.region, options.dimension);
  const auto [smallest, largest] = std::minmax_element(radii.begin(), radii.end());
  require_size(box, options.dimension, *smallest, *largest);
  const double first = root(easy / wanted, options.dimension);
  std::vector<double> small = radii;
  for (double& radius : small) radius *= first;
  const Placement placement(options, small);
  return grow(options, radii, placement.obstacles(), placement.find(random, distances), first);
}

}  // namespace

double expected_count(const CloudOptions& options, const RadiusDistribution& radii, Random random) {
  check_options(options, radii);
  if (options.count) return double(*options.count);
  const std::vector<double> some = draw_radii(radii, drawn_at_once, random);
  return double(drawn_at_once) * wanted_volume(options) / total_volume(some, options.dimension);
}

Cloud fill_randomly(const CloudOptions& options, const RadiusDistribution& distribution, Random& random) {
  if (const double bodies = expected_count(options, distribution, random); bodies > double(max_cloud_bodies))
    throw Error("random cloud", fmt::format("the solid fraction needs about {:.3g} bodies", bodies),
                "give larger radii or a smaller region");
  Cloud cloud;
  std::vector<double> radii;
  if (options.count) {
    radii = draw_radii(distribution, std::size_t(*options.count), random);
  } else {
    radii = radii_of_volume(wanted_volume(options), distribution, options.dimension, random);
    cloud.radius_factor = scale_to(wanted_volume(options), radii, options.dimension);
  }
  const std::vector<Vec3> places = places_of(options, radii, random, cloud.distances);
  cloud.solid_fraction =
      total_volume(radii, options.dimension) / volume_of(options.region, options.dimension);
  cloud.packing.dimension = options.dimension;
  cloud.packing.bounds = bounds_of(options.region, options.dimension);
  cloud.packing.periodic = options.periodic;
  cloud.packing.bodies.resize(radii.size());
  for (std::size_t k = 0; k < radii.size(); ++k) {
    Body& body = cloud.packing.bodies[k];
    body.id = std::int64_t(k) + 1;
    body.radius = radii[k];
    body.position = places[k];
  }
  check(cloud.packing);
  return cloud;
}

}  // namespace scree::packing
