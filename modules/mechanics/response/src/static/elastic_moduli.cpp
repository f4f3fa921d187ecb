#include "static/static_packing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/median.hpp>
#include <scree/response/elastic_moduli.hpp>
#include <scree/response/load_response.hpp>

namespace scree::response {

namespace {

using Vector = Eigen::VectorXd;

// A packing between its two walls, strained by the upper one.
class StrainedPacking {
 public:
  StrainedPacking(const Simulation& simulation, const AssemblyOptions& options,
                  const std::function<bool()>& proceed)
      : simulation_(simulation),
        walls_(wall_pair(simulation)),
        dimension_(simulation.dimension()),
        packing_(simulation, {options.fewest_contacts, true, options.at_limit}, proceed) {}

  const WallPair& walls() const { return walls_; }
  std::size_t rattlers() const { return packing_.system().rattlers.size(); }

  StrainResponse strain_along(int axis) {
    // The wall moves inwards, or along itself.
    const double sign = axis == walls_.axis ? -1 : 1;
    Vector walls = Vector::Zero(packing_.system().wall_stiffness.cols());
    walls[Eigen::Index(walls_.high) * dimension_ + axis] = sign;
    motion_ = packing_.displace(walls);
    if (!(motion_.residual <= LoadResponse::largest_residual))
      throw Error(fmt::format(
          "the strain along {} drives a floppy mode, so that there is no static response (residual {:.1g}); "
          "compress the packing further, or leave --elastic out",
          "xyz"[axis], motion_.residual));
    return sums(axis, sign);
  }

 private:
  // Component k of the vector from the centre of b, or from the wall, to the centre of a.
  double branch(const ContactTerms& c, int k) const {
    const Particles& p = simulation_.particles();
    const double radii = p.radius()[c.a] + (c.b < p.size() ? p.radius()[c.b] : 0);
    return (radii - packing_.list().overlap[c.contact]) *
           packing_.list().normal[3 * c.contact + std::size_t(k)];
  }

  StrainResponse sums(int axis, double sign) const {
    const std::size_t bodies = packing_.system().freedom.bodies();
    double high = 0, low = 0;
    std::vector<double> virial(std::size_t(dimension_), 0.0), before = virial;
    for (const ContactTerms& c : packing_.contacts()) {
      if (!packing_.is_held(c.a) || !packing_.is_held(c.b)) continue;
      const Vector change = packing_.force_change(motion_, c);
      if (c.b == bodies + walls_.high) high += change[axis];
      if (c.b == bodies + walls_.low) low += change[axis];
      for (int k = 0; k < dimension_; ++k) {
        // A wall is flat: the branch vector along it stays 0.
        const bool along_wall = c.b >= bodies && k != walls_.axis;
        const double stretch =
            along_wall ? 0 : packing_.component(motion_, c.a, k) - packing_.component(motion_, c.b, k);
        const double force = c.force[k];
        virial[std::size_t(k)] += change[k] * branch(c, k) + force * stretch;
        before[std::size_t(k)] += force * branch(c, k);
      }
    }
    const double volume = walls_.area * walls_.distance;
    // The change of the volume by the strain of 1 m.
    const double growth = axis == walls_.axis ? sign / walls_.distance : 0;
    for (std::size_t k = 0; k < virial.size(); ++k)
      virial[k] = (virial[k] - growth * before[k]) / volume * walls_.distance;
    const double modulus = sign * high / walls_.area * walls_.distance;
    return {.axis = axis,
            .modulus = modulus,
            .middle_modulus = modulus / (sign * middle_slope(axis) * walls_.distance),
            .virial = virial,
            .balance = std::abs(high + low) / std::abs(high),
            .residual = motion_.residual};
  }

  // Slope of the displacement along an axis over the height in the middle half. Medians of its outer quarters
  // are used because loosely held bodies move by any amount.
  double middle_slope(int axis) const {
    const Particles& p = simulation_.particles();
    const double start = simulation_.planes()[walls_.low].point[walls_.axis];
    std::vector<double> height[2], displacement[2];
    for (std::uint32_t i = 0; i < p.size(); ++i) {
      const double y = (p.position()[walls_.axis][i] - start) / walls_.distance - 0.5;
      if (!packing_.is_held(i) || std::abs(y) > 0.25 || std::abs(y) < 0.125) continue;
      height[y > 0].push_back(y * walls_.distance);
      displacement[y > 0].push_back(packing_.component(motion_, i, axis));
    }
    if (height[0].empty() || height[1].empty()) return std::numeric_limits<double>::quiet_NaN();
    // The mean of the two in the middle, so that the sign of a displacement does not count.
    return (median(displacement[1]) - median(displacement[0])) / (median(height[1]) - median(height[0]));
  }

  const Simulation& simulation_;
  WallPair walls_;
  int dimension_;
  StaticPacking packing_;
  PackingMotion motion_;
};

// The axis across which a wall lies, and its side: 1 below the bodies, −1 above them, 0 for other walls.
std::pair<int, int> side_of(const scree_plane& plane, int dimension) {
  for (int k = 0; k < dimension; ++k)
    if (std::abs(plane.normal[k]) > 1 - 1e-12) return {k, plane.normal[k] > 0 ? 1 : -1};
  return {0, 0};
}

std::string periodic_axes(const Simulation& simulation) {
  std::string text;
  for (int k = 0; k < simulation.dimension(); ++k)
    if (simulation.domain().periodic[std::size_t(k)]) text += "xyz"[k];
  return text.empty() ? "none" : text;
}

}  // namespace

WallPair wall_pair(const Simulation& simulation) {
  if (const std::size_t fixed = simulation.footprint().fixed_bodies + simulation.footprint().held_bodies;
      fixed > 0)
    throw Error(fmt::format(
        "elastic constants are those of bodies between two walls, and here {} too, which {} load; leave "
        "--elastic out, or the [[group]] that fixes them",
        counted(fixed, "body is fixed", "bodies are fixed"), fixed == 1 ? "bears" : "bear"));
  const std::vector<scree_plane>& planes = simulation.planes();
  const int dimension = simulation.dimension();
  const auto there = std::count(simulation.absent_walls().begin(), simulation.absent_walls().end(), 0);
  const auto refuse = [&] {
    return Error(fmt::format(
        "elastic constants need two parallel walls across an axis and periodic boundaries along {}; here are {} "
        "wall{} and the periodic axes {}; leave --elastic out, or prepare such a packing",
        dimension == 2 ? "the other axis" : "the other two", there, there == 1 ? "" : "s",
        periodic_axes(simulation)));
  };
  const auto& absent = simulation.absent_walls();
  if (planes.size() != 2 || absent[0] || absent[1]) throw refuse();
  const auto [axis, first] = side_of(planes[0], dimension);
  const auto [other_axis, second] = side_of(planes[1], dimension);
  if (first * second != -1 || axis != other_axis) throw refuse();
  WallPair pair = {
      .low = first > 0 ? 0u : 1u, .high = first > 0 ? 1u : 0u, .axis = axis, .distance = 0, .area = 1};
  pair.distance = planes[pair.high].point[axis] - planes[pair.low].point[axis];
  for (int k = 0; k < dimension; ++k) {
    if (k == axis) continue;
    if (!simulation.domain().periodic[std::size_t(k)]) throw refuse();
    pair.area *= simulation.domain().length(k);
  }
  return pair;
}

ElasticModuli elastic_moduli(const Simulation& simulation, const AssemblyOptions& options,
                             const std::function<bool()>& proceed) {
  StrainedPacking packing(simulation, options, proceed);
  const auto next = [&](int axis) {
    if (!proceed())
      throw Error("interrupted before the elastic constants were known", ExitStatus::interrupted);
    return packing.strain_along(axis);
  };
  ElasticModuli moduli = {packing.walls(), next(packing.walls().axis), {}, packing.rattlers()};
  for (int k = 0; k < simulation.dimension(); ++k)
    if (k != moduli.walls.axis) moduli.shear.push_back(next(k));
  return moduli;
}

double ElasticModuli::shear_modulus() const {
  double sum = 0;
  for (const StrainResponse& s : shear) sum += s.modulus;
  return sum / double(shear.size());
}

double ElasticModuli::youngs_modulus() const {
  const double m = compression.modulus, g = shear_modulus();
  return shear.size() == 1 ? 4 * g * (m - g) / m : g * (3 * m - 4 * g) / (m - g);
}

double ElasticModuli::poissons_ratio() const {
  const double m = compression.modulus, g = shear_modulus();
  return shear.size() == 1 ? (m - 2 * g) / m : (m - 2 * g) / (2 * (m - g));
}

double ElasticModuli::lateral_ratio() const {
  double sum = 0;
  for (const StrainResponse& s : shear) sum += compression.virial[std::size_t(s.axis)];
  return sum / double(shear.size()) / compression.modulus;
}

double ElasticModuli::poissons_ratio_by_lateral_ratio() const {
  const double ratio = lateral_ratio();
  return shear.size() == 1 ? ratio : ratio / (1 + ratio);
}

}  // namespace scree::response
