#include "growth.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/thread_pool.hpp>

namespace scree::packing {

namespace {

// Overlap, over the smaller radius, at which bodies count as clear of each other; they grow by twice as much
// more than they have to, so that none is left.
constexpr double fraction_tolerance = 1e-4, excess = 2e-4;
constexpr double first_growth = 0.02, least_growth = 1e-4;  // of the radii, in one go
constexpr int most_sweeps = 2000;                           // of all pairs, in one go

class Growth {
 public:
  Growth(const CloudOptions& options, const std::vector<double>& radii, const std::vector<Sphere>& obstacles,
         const std::vector<Vec3>& places)
      : options_(options), box_(bounds_of(options.region, options.dimension)) {
    domain_ = {options.periodic, box_.lower, box_.upper};
    for (std::size_t i = 0; i < radii.size(); ++i) spheres_.push_back({places[i], radii[i]});
    free_ = spheres_.size();
    spheres_.insert(spheres_.end(), obstacles.begin(), obstacles.end());
    double sum = 0.0;
    for (const double radius : radii) sum += radius;
    skin_ = 0.3 * sum / double(radii.size());
  }

  std::vector<Vec3> from(double scale) {
    for (double growth = first_growth; scale < 1.0;) {
      const double next = std::min(1.0, scale * (1.0 + growth));
      const std::vector<Sphere> before = spheres_;
      if (clear(next)) {
        scale = next;
        continue;
      }
      spheres_ = before;
      growth *= 0.5;
      if (growth < least_growth) refuse(scale);
    }
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < free_; ++i) places.push_back(spheres_[i].position);
    return places;
  }

 private:
  bool is_free(std::uint32_t i) const { return i < free_; }
  double radius(std::uint32_t i, double scale) const {
    return is_free(i) ? scale * (1.0 + excess) * spheres_[i].radius : spheres_[i].radius;
  }

  // Moves bodies until none overlaps at this scale of the radii. Returns whether that is reached.
  bool clear(double scale) {
    search(scale);
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      if (travel() > 0.5 * skin_) search(scale);
      const double largest = push_pairs(scale);
      for (std::uint32_t i = 0; i < free_; ++i) confine(i, scale);
      if (largest <= fraction_tolerance) return true;
    }
    return false;
  }

  void search(double scale) {
    std::vector<Sphere> now = spheres_;
    for (std::uint32_t i = 0; i < now.size(); ++i) {
      now[i].radius = radius(i, scale);
      for (int k = 0; k < options_.dimension; ++k)
        if (domain_.periodic[std::size_t(k)])
          now[i].position[k] -=
              std::floor((now[i].position[k] - domain_.lower[k]) / domain_.length(k)) * domain_.length(k);
      spheres_[i].position = now[i].position;
    }
    pairs_ = search_.find(now, options_.dimension, domain_, skin_, thread_);
    at_search_ = spheres_;
  }

  double travel() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < free_; ++i)
      largest = std::max(largest, norm(spheres_[i].position - at_search_[i].position));
    return largest;
  }

  // Parts the bodies of each pair that overlap, one pair after the other. Returns the largest overlap over
  // the smaller radius before.
  double push_pairs(double scale) {
    double largest = 0.0;
    for (const NeighbourPair& pair : pairs_) {
      if (!is_free(pair.a) && !is_free(pair.b)) continue;
      Vec3 &a = spheres_[pair.a].position, &b = spheres_[pair.b].position;
      const Vec3 apart = a - b + domain_.shift(pair.image);
      const double distance = norm(apart), radius_a = radius(pair.a, scale), radius_b = radius(pair.b, scale);
      const double overlap = radius_a + radius_b - distance;
      if (overlap <= 0.0) continue;
      largest = std::max(largest, overlap / std::min(radius_a, radius_b));
      const Vec3 push = distance > 0.0 ? (overlap / distance) * apart : Vec3{{overlap, 0.0, 0.0}};
      const double share = !is_free(pair.a) ? 0.0 : is_free(pair.b) ? 0.5 : 1.0;
      a = a + share * push;
      b = b - (1.0 - share) * push;
    }
    return largest;
  }

  // Moves a body into the region; one that fits without its excess alone, into the middle.
  void confine(std::uint32_t i, double scale) {
    const double r = radius(i, scale);
    Vec3& x = spheres_[i].position;
    for (int k = 0; k < options_.dimension; ++k)
      if (!options_.periodic[std::size_t(k)]) x[k] = confined(x[k], box_.lower[k] + r, box_.upper[k] - r);
    if (const auto* ball = std::get_if<Ball>(&options_.region))
      confine_to(ball->centre, std::max(0.0, ball->radius - r), options_.dimension == 2 ? 2 : -1, x);
    if (const auto* cylinder = std::get_if<Cylinder>(&options_.region))
      confine_to(cylinder->centre, std::max(0.0, cylinder->radius - r), cylinder->axis, x);
  }

  static double confined(double x, double low, double high) {
    return low < high ? std::clamp(x, low, high) : 0.5 * (low + high);
  }

  // Moves a point to within a distance of a centre, along other axes than `without`.
  static void confine_to(Vec3 centre, double distance, int without, Vec3& x) {
    if (without >= 0) centre[without] = x[without];
    const double now = norm(x - centre);
    if (now > distance) x = centre + (distance / now) * (x - centre);
  }

  [[noreturn]] void refuse(double scale) const {
    double volume = 0.0;
    for (std::size_t i = 0; i < free_; ++i)
      volume += volume_of_body(scale * spheres_[i].radius, options_.dimension);
    throw Error(
        "random cloud",
        fmt::format("bodies that grow to their radii jam at {:.3g} of these, a solid fraction of {:.3g}",
                    scale, volume / volume_of(options_.region, options_.dimension)),
        "give a smaller solid fraction or fewer bodies, or a larger region");
  }

  const CloudOptions& options_;
  Bounds box_;
  Domain domain_;
  std::vector<Sphere> spheres_, at_search_;  // obstacles behind the bodies
  std::size_t free_ = 0;
  double skin_ = 0.0;  // (m)
  PairSearch search_{PairSearch::Images::nearest};
  ThreadPool thread_{1};
  std::vector<NeighbourPair> pairs_;
};

}  // namespace

std::vector<Vec3> grow(const CloudOptions& options, const std::vector<double>& radii,
                       const std::vector<Sphere>& obstacles, std::vector<Vec3> places, double first) {
  return Growth(options, radii, obstacles, places).from(first);
}

}  // namespace scree::packing
