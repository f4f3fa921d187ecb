#include "body_force_terms.hpp"
#include "entries.hpp"
#include "static_contacts.hpp"
#include "static_state.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/response/quasi_static.hpp>

namespace scree::response {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// Systems up to this size are solved by a dense factorisation.
constexpr Eigen::Index largest_dense = 200;
// Newton iterations of an increment.
constexpr int most_iterations = 40;
// Smallest share of a Newton step, and by how much the residual must fall over the share.
constexpr double shortest_share = 1.0 / 64, least_gain = 0.1;
// Added to the diagonal of K, over its largest entry, against floppy modes and bodies without contacts. More where Newton steps do not
// make the residual smaller.
constexpr double least_grounding = 1e-8, largest_grounding = 1;
// Longest Newton step, over the smallest radius.
constexpr double longest_step = 0.005;
// Gap within which pairs are kept, over the smallest radius.
constexpr double pair_gap = 0.4;

DegreesOfFreedom all_motions(const Simulation& simulation, int spins, const WallEquations& walls) {
  const std::vector<bool> bodies(simulation.particles().size(), true);
  std::vector<bool> free;
  for (const scree_linear_plane& wall : walls.walls) free.push_back(wall.free != 0);
  return DegreesOfFreedom(simulation.dimension(), spins, bodies, std::vector<bool>(bodies.size(), spins > 0),
                          free);
}

int spins_of(const Particles& p) { return p.spin_axes().last - p.spin_axes().first; }

}  // namespace

class QuasiStatic::Packing {
 public:
  Packing(const Simulation& simulation, const QuasiStaticOptions& options)
      : simulation_(simulation),
        options_(options),
        walls_(simulation.linear_walls()),
        freedom_(all_motions(simulation, spins_of(simulation.particles()), walls_)),
        configuration_(simulation),
        contacts_(simulation, freedom_.spins()),
        body_forces_(linearise_body_forces(simulation, freedom_.spins())),
        at_start_(configuration_.position),
        time_(simulation.time()) {
    if (!(options_.longest_increment > 0))
      throw Error("a quasi-static load needs an increment above 0 s; give one");
    if (options_.shortest_increment <= 0) options_.shortest_increment = options_.longest_increment / 64;
    const auto radii = simulation.particles().radius();
    smallest_radius_ = *std::min_element(radii.begin(), radii.end());
    next_increment_ = options_.longest_increment;
    contacts_.find_pairs(configuration_, pair_gap * smallest_radius_);
    refuse_moving_walls();
    scale_ = row_scales();
  }

  bool advance(double time) {
    // Times closer than this are the same.
    const double round_off = 1e-12 * std::max(std::abs(time), options_.longest_increment);
    while (time - time_ > round_off || !balanced_) {
      const double left = std::max(time - time_, 0.0);
      const double increment = std::min(next_increment_, left);
      if (!take(increment < left ? time_ + increment : time)) return false;
    }
    return true;
  }

  double time() const { return time_; }
  const QuasiStaticCounts& counts() const { return counts_; }
  std::size_t count(PairStatus status) const { return contacts_.count(status); }
  std::size_t size() const { return std::size_t(freedom_.size()); }
  std::size_t bodies() const { return freedom_.bodies(); }
  State state() const {
    return static_state(simulation_, time_, configuration_, contacts_.touching(), loads_);
  }
  std::vector<scree_plane> planes() const {
    std::vector<scree_plane> all = simulation_.planes();
    for (std::size_t w = 0; w < all.size(); ++w)
      for (int k = 0; k < 3; ++k) {
        all[w].point[k] = configuration_.position[bodies() + w][k];
        all[w].velocity[k] = all[w].mid_velocity[k] = 0;
      }
    return all;
  }
  std::vector<scree_load> wall_loads() const {
    std::vector<scree_load> all;
    for (std::size_t w = 0; w < freedom_.walls(); ++w) {
      const Vec3& force = loads_.force[bodies() + w];
      all.push_back({force[0], force[1], force[2]});
    }
    return all;
  }

 private:
  // Result of the Newton iteration of one increment.
  struct Balance {
    bool found;
    Vector motion;
    StaticConfiguration at;
    StaticLoads loads;
  };

  void refuse_moving_walls() const {
    for (std::size_t w = 0; w < walls_.walls.size(); ++w)
      if (walls_.walls[w].speed != 0)
        throw Error(fmt::format(
            "wall {} is moved with {:g} m/s at t = {:g} s; a quasi-static load is by stresses or forces on walls",
            simulation_.plane_names()[w], walls_.walls[w].speed, time_));
  }

  // Takes an increment to a time, halved until there is an equilibrium at its end. Returns false if there is none.
  bool take(double time) {
    for (;;) {
      const double increment = time - time_;
      walls_ = simulation_.linear_walls(time);
      refuse_moving_walls();
      Balance balance = find_balance(increment);
      if (balance.found) {
        accept(std::move(balance), time, increment);
        return true;
      }
      if (increment < 1.5 * options_.shortest_increment) return false;
      time = time_ + std::max(0.5 * increment, options_.shortest_increment);
    }
  }

  void accept(Balance balance, double time, double increment) {
    ++counts_.increments;
    counts_.events += contacts_.events();
    contacts_.commit();
    configuration_ = std::move(balance.at);
    loads_ = std::move(balance.loads);
    if (increment > 0) last_rate_ = 1 / increment * balance.motion;
    time_ = time;
    balanced_ = true;
    next_increment_ =
        std::min(options_.longest_increment, std::max(2 * increment, options_.shortest_increment));
    moved_ += length_of(balance.motion);
    if (4 * moved_ < pair_gap * smallest_radius_) return;
    contacts_.find_pairs(configuration_, pair_gap * smallest_radius_);
    moved_ = 0;
  }

  Balance find_balance(double increment) {
    Balance balance = {
        .found = false, .motion = Vector::Zero(freedom_.size()), .at = configuration_, .loads = {}};
    if (last_rate_.size() > 0) balance.motion = increment * last_rate_;
    double grounding = least_grounding;
    Vector residual = evaluate(balance);
    for (int iteration = 0; iteration < most_iterations && residual.allFinite(); ++iteration) {
      ++counts_.iterations;
      const double force = std::max(contacts_.largest_force(), largest_press());
      balance.found = residual.cwiseProduct(scale_).lpNorm<Eigen::Infinity>() <= options_.tolerance * force;
      if (balance.found) break;
      const std::optional<Vector> step = newton_step(residual, grounding);
      if (!step) break;
      const double share = move_along(balance, *step, residual);
      grounding = share > 0.1 ? std::max(least_grounding, 0.1 * grounding) : 100 * grounding;
      if (grounding > largest_grounding || 4 * length_of(balance.motion) > pair_gap * smallest_radius_) break;
    }
    return balance;
  }

  // Moves on by the largest share of a Newton step that makes the residual smaller: where contacts change between sticking and
  // sliding, the whole step may not. Returns this share, 0 if there is none.
  double move_along(Balance& balance, const Vector& step, Vector& residual) {
    const Vector from = balance.motion;
    const double size = size_of(residual);
    for (double share = 1; share >= shortest_share; share *= 0.5) {
      balance.motion = from + share * step;
      residual = evaluate(balance);
      if (size_of(residual) < (1 - least_gain * share) * size) return share;
    }
    balance.motion = from;
    residual = evaluate(balance);
    return 0;
  }

  // Forces and torques that are not in balance after the motion.
  Vector evaluate(Balance& balance) {
    const StaticMotion motion(balance.motion, freedom_, walls_);
    balance.at = configuration_;
    balance.at.move(motion);
    balance.loads.force.assign(at_start_.size(), Vec3{});
    balance.loads.torque.assign(at_start_.size(), Vec3{});
    contacts_.evaluate(balance.at, motion, balance.loads);
    Vector residual = Vector::Zero(freedom_.size());
    add_bodies(balance, residual);
    add_walls(balance, residual);
    return residual;
  }

  void add_bodies(const Balance& balance, Vector& residual) const {
    const int D = freedom_.dimension(), S = freedom_.spins();
    for (std::uint32_t i = 0; i < freedom_.bodies(); ++i) {
      Vector load(D + S), moved = Vector::Zero(D + S);
      for (int k = 0; k < D; ++k) {
        load[k] = balance.loads.force[i][k];
        moved[k] = balance.at.position[i][k] - at_start_[i][k];
      }
      for (int k = 0; k < S; ++k) load[D + k] = balance.loads.torque[i][D == 2 ? 2 : k];
      if (!body_forces_.empty()) load += body_forces_[i].load - body_forces_[i].stiffness * moved;
      residual.segment(freedom_.translation(i, 0), D) = load.head(D);
      if (S > 0) residual.segment(freedom_.rotation(i, 0), S) = load.tail(S);
    }
  }

  void add_walls(const Balance& balance, Vector& residual) const {
    for (std::size_t w = 0; w < freedom_.walls(); ++w) {
      if (freedom_.wall(w) == DegreesOfFreedom::none) continue;
      double force = walls_.walls[w].pressing_force + along(w, balance.loads.force[freedom_.bodies() + w]);
      for (std::size_t other = 0; other < freedom_.walls(); ++other)
        force -= walls_.stiffness_of(w, other) * displacement_in(balance.at, other);
      residual[freedom_.wall(w)] = force;
    }
  }

  // K of the last evaluation.
  Sparse stiffness() const {
    Entries entries(freedom_, walls_);
    contacts_.add_stiffness(entries);
    for (std::uint32_t i = 0; i < body_forces_.size(); ++i) entries.add({i}, body_forces_[i].stiffness);
    for (std::size_t w = 0; w < freedom_.walls(); ++w)
      for (std::size_t other = 0; other < freedom_.walls(); ++other)
        if (freedom_.wall(w) != DegreesOfFreedom::none)
          entries.add_along(w, other, walls_.stiffness_of(w, other));
    return entries.of_motions();
  }

  std::optional<Vector> newton_step(const Vector& residual, double grounding) const {
    Sparse stiffness = this->stiffness();
    const Vector diagonal = stiffness.diagonal().cwiseAbs();
    double largest = 0;
    for (Eigen::Index i = 0; i < diagonal.size(); ++i)
      largest = std::max(largest, diagonal[i] * scale_[i] * scale_[i]);
    if (!(largest > 0)) return std::nullopt;
    const Vector ground = grounding * largest * scale_.cwiseAbs2().cwiseInverse();
    Vector step;
    if (stiffness.rows() <= largest_dense) {
      Eigen::MatrixXd dense = stiffness;
      dense.diagonal() += ground;
      step = dense.partialPivLu().solve(residual);
    } else {
      Sparse diagonal_part(stiffness.rows(), stiffness.cols());
      diagonal_part.setIdentity();
      diagonal_part.diagonal() = ground;
      stiffness += diagonal_part;
      stiffness.makeCompressed();
      Eigen::SparseLU<Sparse> factors(stiffness);
      if (factors.info() != Eigen::Success) return std::nullopt;
      step = factors.solve(residual);
    }
    if (!step.allFinite()) return std::nullopt;
    shorten(step);
    return step;
  }

  // Bodies that hardly anything holds do not decide for all others how far they move.
  void shorten(Vector& step) const {
    const double allowed = longest_step * smallest_radius_;
    const auto limit = [&](Eigen::Index first, int count) {
      auto part = step.segment(first, count);
      const double length = part.cwiseQuotient(scale_.segment(first, count)).norm();
      if (length > allowed) part *= allowed / length;
    };
    for (std::size_t i = 0; i < freedom_.bodies(); ++i) {
      limit(freedom_.translation(i, 0), freedom_.dimension());
      if (freedom_.spins() > 0) limit(freedom_.rotation(i, 0), freedom_.spins());
    }
  }

  double size_of(const Vector& residual) const { return residual.cwiseProduct(scale_).norm(); }
  // Largest displacement, of surfaces too (m).
  double length_of(const Vector& motion) const {
    return motion.cwiseQuotient(scale_).lpNorm<Eigen::Infinity>();
  }
  double along(std::size_t w, const Vec3& v) const {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += walls_.walls[w].direction[k] * v[k];
    return sum;
  }
  double displacement_in(const StaticConfiguration& at, std::size_t w) const {
    return along(w, at.position[freedom_.bodies() + w] - at_start_[freedom_.bodies() + w]);
  }
  double largest_press() const {
    double largest = 0;
    for (const scree_linear_plane& wall : walls_.walls)
      largest = std::max(largest, std::abs(wall.pressing_force));
    return largest;
  }
  // 1 for forces, 1/R for torques: makes them forces, and rotations over it lengths.
  Vector row_scales() const {
    Vector scale = Vector::Ones(freedom_.size());
    for (std::size_t i = 0; i < freedom_.bodies(); ++i)
      for (int k = 0; k < freedom_.spins(); ++k)
        scale[freedom_.rotation(i, k)] = 1 / simulation_.particles().radius()[i];
    return scale;
  }

  const Simulation& simulation_;
  QuasiStaticOptions options_;
  WallEquations walls_;
  DegreesOfFreedom freedom_;
  StaticConfiguration configuration_;
  StaticContacts contacts_;
  std::vector<BodyForceTerms> body_forces_;
  std::vector<Vec3> at_start_;
  StaticLoads loads_;
  Vector last_rate_, scale_;
  double time_, next_increment_ = 0, smallest_radius_ = 0, moved_ = 0;
  bool balanced_ = false;
  QuasiStaticCounts counts_;
};

QuasiStatic::QuasiStatic(const Simulation& simulation, const QuasiStaticOptions& options)
    : packing_(std::make_unique<Packing>(simulation, options)) {}
QuasiStatic::~QuasiStatic() = default;

bool QuasiStatic::advance(double time) { return packing_->advance(time); }
double QuasiStatic::time() const { return packing_->time(); }
const QuasiStaticCounts& QuasiStatic::counts() const { return packing_->counts(); }
std::size_t QuasiStatic::degrees_of_freedom() const { return packing_->size(); }
std::size_t QuasiStatic::touching() const {
  return packing_->count(PairStatus::sticks) + packing_->count(PairStatus::slides);
}
std::size_t QuasiStatic::sliding() const { return packing_->count(PairStatus::slides); }
std::vector<scree_plane> QuasiStatic::planes() const { return packing_->planes(); }
std::vector<scree_load> QuasiStatic::loads() const { return packing_->wall_loads(); }
State QuasiStatic::state() const { return packing_->state(); }

}  // namespace scree::response
