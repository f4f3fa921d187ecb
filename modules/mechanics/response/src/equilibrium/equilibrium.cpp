#include "equilibrium/equilibrium.hpp"

#include "assembly/entries.hpp"
#include "assembly/group_terms.hpp"

#include <algorithm>
#include <cmath>

namespace scree::response {

namespace {

// Largest number of Newton iterations per increment.
constexpr int most_iterations = 40;
// Smallest fraction of a Newton step, and the reduction of the residual over the fraction that is required.
constexpr double shortest_share = 1.0 / 64, least_gain = 0.1;
// Ratio of residuals after and before a step above which factors of an earlier stiffness are replaced.
constexpr double slow_convergence = 0.1;
// Added to the diagonal of K, relative to its largest entry, because of floppy modes and bodies without
// contacts. It grows where Newton steps do not reduce the residual.
constexpr double least_grounding = 1e-8, largest_grounding = 1;
// Longest Newton step, in smallest radii.
constexpr double longest_step = 0.005;
// Gap up to which pairs are listed, in smallest radii.
constexpr double pair_gap = 0.4;

DegreesOfFreedom all_motions(const Simulation& simulation, int spins, const WallEquations& walls) {
  check_groups(simulation);
  const Particles& p = simulation.particles();
  std::vector<bool> bodies(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) bodies[i] = !p.is_fixed(i);
  std::vector<bool> free;
  for (const scree_linear_wall& wall : walls.walls) free.push_back(wall.free == SCREE_FREE);
  return DegreesOfFreedom(simulation.dimension(), spins, bodies, std::vector<bool>(bodies.size(), spins > 0),
                          free, held_components(p));
}

int spins_of(const Particles& p) { return p.spin_axes().last - p.spin_axes().first; }

// Component of a vector along the direction of a wall.
double along(const WallEquations& walls, std::size_t w, const Vec3& v) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += walls.walls[w].direction[k] * v[k];
  return sum;
}

}  // namespace

Equilibrium::Equilibrium(const Simulation& simulation, double tolerance)
    : simulation_(simulation),
      tolerance_(tolerance),
      walls_at_start_(simulation.linear_walls()),
      freedom_(all_motions(simulation, spins_of(simulation.particles()), walls_at_start_)),
      contacts_(simulation, freedom_.spins()),
      body_forces_(linearise_body_forces(simulation, freedom_.spins())),
      at_start_(StaticConfiguration(simulation).position),
      scale_(Vector::Ones(freedom_.size())) {
  const auto radii = simulation.particles().radius();
  for (std::size_t i = 0; i < freedom_.bodies(); ++i)
    if (const auto [first, count] = freedom_.rotations(i); count > 0)
      scale_.segment(first, count).setConstant(1 / radii[i]);
  // A drag, for example, is 0 at rest.
  if (std::all_of(body_forces_.begin(), body_forces_.end(), [](const BodyForceTerms& terms) {
        return terms.load.isZero(0) && terms.stiffness.isZero(0);
      }))
    body_forces_.clear();
  smallest_radius_ = *std::min_element(radii.begin(), radii.end());
  contacts_.find_pairs(StaticConfiguration(simulation), pair_gap * smallest_radius_);
}

Balance Equilibrium::find(const StaticConfiguration& from, double time, const Vector& guess,
                          const std::function<bool()>& proceed) {
  Search search = {from, time, {false, guess, from, {}}, {}};
  Balance& balance = search.balance;
  if (guess.size() == 0) balance.motion = Vector::Zero(freedom_.size());
  double grounding = least_grounding;
  Vector residual = evaluate(search);
  for (int iteration = 0; iteration < most_iterations && residual.allFinite() && proceed(); ++iteration) {
    ++iterations_;
    balance.found =
        residual.cwiseProduct(scale_).lpNorm<Eigen::Infinity>() <= tolerance_ * largest_force(search.walls);
    if (balance.found) break;
    const bool present = !factors_;
    if (present && !factorise(search.walls, grounding)) break;
    const double size = size_of(residual);
    const double share = present
                             ? move_along(search, step_for(residual), shortest_share, least_gain, residual)
                             : move_along(search, step_for(residual), 1, 1 - slow_convergence, residual);
    if (share < 1 || size_of(residual) > slow_convergence * size) factors_.discard();
    if (present) grounding = share > 0.1 ? std::max(least_grounding, 0.1 * grounding) : 100 * grounding;
    if (grounding > largest_grounding || 4 * length_of(balance.motion) > pair_gap * smallest_radius_) break;
  }
  if (!balance.found) factors_.discard();
  return std::move(search.balance);
}

void Equilibrium::accept(const Balance& balance) {
  contacts_.commit();
  moved_ += length_of(balance.motion);
  if (4 * moved_ < pair_gap * smallest_radius_) return;
  contacts_.find_pairs(balance.at, pair_gap * smallest_radius_);
  moved_ = 0;
}

Equilibrium::Vector Equilibrium::without_free_bodies(Vector motion) const {
  const std::vector<bool> touched = contacts_.touched();
  for (std::size_t i = 0; i < freedom_.bodies(); ++i) {
    if (touched[i] || !freedom_.moves(i)) continue;
    for (const auto& [first, count] : {freedom_.translations(i), freedom_.rotations(i)})
      if (count > 0) motion.segment(first, count).setZero();
  }
  return motion;
}

double Equilibrium::move_along(Search& search, const Vector& step, double shortest, double gain,
                               Vector& residual) {
  const Vector from = search.balance.motion;
  const double size = size_of(residual);
  for (double share = 1; share >= shortest; share *= 0.5) {
    search.balance.motion = from + share * step;
    residual = evaluate(search);
    if (size_of(residual) < (1 - gain * share) * size) return share;
  }
  search.balance.motion = from;
  residual = evaluate(search);
  return 0;
}

Equilibrium::Vector Equilibrium::evaluate(Search& search) {
  Balance& balance = search.balance;
  const StaticMotion motion(balance.motion, freedom_, walls_at_start_);
  balance.at = search.from;
  balance.at.move(motion);
  search.walls =
      simulation_.linear_walls(search.time, balance.at.planes(simulation_), balance.at.frames(simulation_));
  balance.loads.force.assign(at_start_.size(), Vec3{});
  balance.loads.torque.assign(at_start_.size(), Vec3{});
  contacts_.evaluate(balance.at, motion, balance.loads);
  Vector residual = Vector::Zero(freedom_.size());
  add_bodies(search, residual);
  add_walls(search, residual);
  return residual;
}

void Equilibrium::add_bodies(const Search& search, Vector& residual) const {
  const Balance& balance = search.balance;
  const int D = freedom_.dimension(), S = freedom_.spins();
  for (std::uint32_t i = 0; i < freedom_.bodies(); ++i) {
    if (!freedom_.moves(i)) continue;
    Vector load(D + S), moved = Vector::Zero(D + S);
    for (int k = 0; k < D; ++k) {
      load[k] = balance.loads.force[i][k];
      moved[k] = balance.at.position[i][k] - at_start_[i][k];
    }
    for (int k = 0; k < S; ++k) load[D + k] = balance.loads.torque[i][D == 2 ? 2 : k];
    if (!body_forces_.empty()) load += body_forces_[i].load - body_forces_[i].stiffness * moved;
    for (int k = 0; k < D + S; ++k)
      if (const Eigen::Index number = k < D ? freedom_.translation(i, k) : freedom_.rotation(i, k - D);
          number != DegreesOfFreedom::none)
        residual[number] = load[k];
  }
}

void Equilibrium::add_walls(const Search& search, Vector& residual) const {
  const WallEquations& walls = search.walls;
  const std::size_t bodies = freedom_.bodies();
  for (std::size_t w = 0; w < freedom_.walls(); ++w) {
    if (freedom_.wall(w) == DegreesOfFreedom::none) continue;
    residual[freedom_.wall(w)] =
        walls.walls[w].pressing_force + along(walls, w, search.balance.loads.force[bodies + w]);
  }
}

Equilibrium::Sparse Equilibrium::stiffness(const WallEquations& walls) const {
  Entries entries(freedom_, walls);
  contacts_.add_stiffness(entries);
  for (std::uint32_t i = 0; i < body_forces_.size(); ++i) entries.add({i}, body_forces_[i].stiffness);
  for (std::size_t w = 0; w < freedom_.walls(); ++w)
    for (std::size_t other = 0; other < freedom_.walls(); ++other)
      if (freedom_.wall(w) != DegreesOfFreedom::none)
        entries.add_along(w, other, walls.stiffness_of(w, other));
  return entries.of_motions();
}

bool Equilibrium::factorise(const WallEquations& walls, double grounding) {
  const Sparse stiffness = this->stiffness(walls);
  const double largest = stiffness.diagonal().cwiseAbs().cwiseProduct(scale_.cwiseAbs2()).maxCoeff();
  return largest > 0 &&
         factors_.factorise(stiffness, grounding * largest * scale_.cwiseAbs2().cwiseInverse());
}

double Equilibrium::length_of(const Vector& motion) const {
  double longest = 0;
  for_each_motion([&](Eigen::Index first, Eigen::Index count) {
    const auto part = motion.segment(first, count).cwiseQuotient(scale_.segment(first, count));
    longest = std::max(longest, part.norm());
  });
  for (std::size_t w = 0; w < freedom_.walls(); ++w)
    if (freedom_.wall(w) != DegreesOfFreedom::none)
      longest = std::max(longest, std::abs(motion[freedom_.wall(w)]));
  return longest;
}

// Limits the motion of each body separately, so that loosely held bodies do not shorten the step of all
// others. Bodies without contacts do not move: factors of an earlier search may have contacts that are open
// now.
Equilibrium::Vector Equilibrium::step_for(const Vector& residual) const {
  Vector step = factors_.solve(residual);
  if (body_forces_.empty()) step = without_free_bodies(std::move(step));
  const double allowed = longest_step * smallest_radius_;
  for_each_motion([&](Eigen::Index first, Eigen::Index count) {
    auto part = step.segment(first, count);
    const double length = part.cwiseQuotient(scale_.segment(first, count)).norm();
    if (length > allowed) part *= allowed / length;
  });
  return step;
}

double Equilibrium::largest_force(const WallEquations& walls) const {
  double largest = contacts_.largest_force();
  for (const scree_linear_wall& wall : walls.walls)
    largest = std::max(largest, std::abs(wall.pressing_force));
  return largest;
}

}  // namespace scree::response
