#include "assembly/body_force_terms.hpp"

#include <array>

#include <scree/plugin/program.hpp>

namespace scree::response {

namespace {

// Steps of the differences, in radii and in radii per time step: small compared with the lengths and speeds
// over which a body force changes, large compared with round-off.
constexpr double probe_displacement = 1e-4, probe_speed = 1e-6;

// One body as a plug-in sees it.
class SingleBody {
 public:
  SingleBody(const Simulation& simulation, std::size_t i, int spins)
      : simulation_(simulation), dimension_(simulation.dimension()), spins_(spins) {
    const Particles& p = simulation.particles();
    const Body body = p.body(i);
    for (int k = 0; k < 3; ++k) state_[std::size_t(k)] = body.position[k];
    state_[radius] = body.radius, state_[mass] = body.mass, state_[inertia] = body.inertia;
    for (int k = 0; k < dimension_; ++k) {
      if (p.image[k].empty()) continue;
      image_[std::size_t(k)] = p.image[k][i];
      period_[std::size_t(k)] = simulation.domain().length(k);
    }
  }

  double& position(int k) { return state_[std::size_t(k)]; }
  // Component k of velocity, then spin.
  double& motion(int k) {
    return state_[k < dimension_ ? velocity + std::size_t(k) : spin + spin_axis(k - dimension_)];
  }
  // Force, then torque, of all plug-ins.
  Eigen::VectorXd load() {
    load_.fill(0);
    add_body_forces();
    Eigen::VectorXd all(dimension_ + spins_);
    for (int k = 0; k < dimension_; ++k) all[k] = load_[std::size_t(k)];
    for (int k = 0; k < spins_; ++k) all[dimension_ + k] = load_[3 + spin_axis(k)];
    return all;
  }

 private:
  enum Column : std::size_t { velocity = 3, spin = 6, radius = 9, mass = 10, inertia = 11, columns = 12 };
  std::size_t spin_axis(int k) const { return std::size_t(dimension_ == 2 ? 2 : k); }

  void add_body_forces() {
    scree_body_batch batch = {};
    batch.struct_size = sizeof(batch);
    batch.dimension = std::uint32_t(dimension_);
    batch.count = 1;
    for (std::size_t k = 0; k < std::size_t(dimension_); ++k) {
      batch.position[k] = {&state_[k], 1};
      batch.velocity[k] = {&state_[velocity + k], 1};
      batch.force[k] = {&load_[k], 1};
      batch.image[k] = period_[k] > 0 ? &image_[k] : nullptr;
      batch.period[k] = period_[k];
    }
    for (int k = 0; k < spins_; ++k) {
      batch.spin[spin_axis(k)] = {&state_[spin + spin_axis(k)], 1};
      batch.torque[spin_axis(k)] = {&load_[3 + spin_axis(k)], 1};
    }
    batch.radius = {&state_[radius], 1};
    batch.mass = {&state_[mass], 1};
    batch.inertia = {&state_[inertia], 1};
    simulation_.add_body_forces(batch);
  }

  const Simulation& simulation_;
  int dimension_, spins_;
  std::array<double, columns> state_ = {};
  std::array<double, 6> load_ = {};
  std::array<std::int32_t, 3> image_ = {};
  std::array<double, 3> period_ = {};
};

// Derivative of the loads of a body by one of its numbers.
Eigen::VectorXd difference(SingleBody& body, double& number, double change) {
  const double before = number;
  number = before + change;
  const double upper = number;
  const Eigen::VectorXd more = body.load();
  number = before - change;
  const double lower = number;
  const Eigen::VectorXd less = body.load();
  number = before;
  return (more - less) / (upper - lower);
}

// Constant loads (N), (N m).
void add_loads(const BodyGroup& group, int dimension, int spins, std::vector<BodyForceTerms>& terms) {
  for (int k = 0; k < dimension + spins; ++k) {
    const int component = k < dimension    ? k
                          : dimension == 2 ? freedom::count - 1
                                           : freedom::first_rotation + k - dimension;
    const std::vector<double>& load = group.load[std::size_t(component)];
    if (load.empty()) continue;
    const double now = Program({.data = load.data(), .count = load.size()})(0);
    for (const std::uint32_t i : group.bodies) terms[i].load[k] += now;
  }
}

}  // namespace

std::vector<BodyForceTerms> linearise_body_forces(const Simulation& simulation, int spins) {
  std::vector<BodyForceTerms> terms;
  const std::vector<BodyGroup>& groups = simulation.scene().groups;
  if (simulation.scene().body_forces.empty() && groups.empty()) return terms;
  const int D = simulation.dimension(), of_body = D + spins;
  for (std::size_t i = 0; i < simulation.particles().size(); ++i) {
    SingleBody body(simulation, i, spins);
    const double radius = simulation.particles().radius()[i];
    BodyForceTerms of = {Block::Zero(of_body, of_body), Block::Zero(of_body, of_body), body.load()};
    for (int k = 0; k < D; ++k)
      of.stiffness.col(k) = -difference(body, body.position(k), probe_displacement * radius);
    for (int k = 0; k < of_body; ++k) {
      const double change = probe_speed * (k < D ? radius : 1) / simulation.step_length();
      of.damping.col(k) = -difference(body, body.motion(k), change);
    }
    terms.push_back(of);
  }
  for (const BodyGroup& group : groups) add_loads(group, D, spins, terms);
  return terms;
}

}  // namespace scree::response
