#include "equilibrium/pairs_of_law.hpp"

#include "assembly/contact_terms.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace scree::response {

namespace {

// Duration of an increment (s) for the dashpots of the laws: so long that their forces are round-off.
constexpr double duration = 1e15;

scree_arms arms_of(const ConfiguredLaw& law) { return scree_arms(law.instance().arms); }

}  // namespace

PairsOfLaw::PairsOfLaw(const Simulation& simulation, std::uint32_t law, Partner partner, int spins)
    : simulation_(simulation),
      partner_(partner),
      law_(differentiable(simulation.scene().laws[law], simulation.dimension())),
      jacobian_(law_, simulation.dimension()),
      spins_(spins) {}

void PairsOfLaw::set_pairs(std::vector<StaticPair> pairs) {
  const auto order = [](const StaticPair& p) { return std::tie(p.a, p.b); };
  std::vector<double> history(pairs.size() * width(), 0.0);
  std::vector<PairState> states(pairs.size());
  for (std::size_t i = 0, k = 0; i < pairs.size(); ++i) {
    while (k < pairs_.size() && order(pairs_[k]) < order(pairs[i])) ++k;
    if (k == pairs_.size() || order(pairs_[k]) != order(pairs[i])) continue;
    std::copy_n(history_.begin() + std::ptrdiff_t(k * width()), width(),
                history.begin() + std::ptrdiff_t(i * width()));
    states[i] = states_[k];
  }
  pairs_ = std::move(pairs);
  history_ = std::move(history);
  states_ = std::move(states);
}

void PairsOfLaw::set_history(std::uint32_t a, std::uint32_t b, const std::vector<double>& history,
                             bool sliding) {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].a != a || pairs_[i].b != b) continue;
    std::copy_n(history.begin(), width(), history_.begin() + std::ptrdiff_t(i * width()));
    states_[i].status = sliding ? PairStatus::slides : PairStatus::sticks;
  }
}

void PairsOfLaw::fill(std::size_t i, const PairPlace& at, const StaticConfiguration& after,
                      const StaticMotion& motion) {
  const Particles& p = simulation_.particles();
  ContactColumns& columns = *columns_;
  at.set_inputs(p, after.orientations, law_.instance().reads, columns, i);
  columns.set(SCREE_RELATIVE_VELOCITY, 1 / duration * at.slip(arms_of(law_)), i);
  columns.set(SCREE_TANGENTIAL_INCREMENT, at.tangential_increment(arms_of(law_)), i);
  const Vec3 spin = 1 / duration * (motion.rotation[at.a] - motion.rotation[at.b]);
  if (p.dimension() == 2)
    columns.input(SCREE_RELATIVE_SPIN, 0, i) = spin[2];
  else
    columns.set(SCREE_RELATIVE_SPIN, spin, i);
  for (std::uint32_t k = 0; k < width(); ++k) columns.history(k, i) = history_[i * width() + k];
}

void PairsOfLaw::add_loads(std::size_t i, StaticLoads& loads) {
  const ContactGeometry& geometry = geometries_[i];
  const bool flat = geometry.dimension == 2;
  Vec3 force = columns_->output_vector(SCREE_FORCE, i), couple = {};
  if (flat) force[2] = 0;
  if (law_.instance().writes_couple) {
    couple = columns_->output_vector(SCREE_COUPLE, i);
    if (flat) couple = {{0, 0, couple[0]}};
  }
  const StaticPair& pair = pairs_[i];
  const Vec3 lever = cross(Vec3{{geometry.normal[0], geometry.normal[1], geometry.normal[2]}}, force);
  loads.force[pair.a] += force;
  loads.force[pair.b] += -1.0 * force;
  const Vec3 torque = couple - geometry.arm_a * lever;
  loads.torque[pair.a] += torque;
  // On a wall about its point.
  loads.torque[pair.b] +=
      places_[i].to_wall() ? -torque - cross(places_[i].separation, force) : -couple - geometry.arm_b * lever;
  largest_force_ = std::max(largest_force_, norm(force));
}

PairState PairsOfLaw::state_of(std::size_t i) {
  PairState state = {.overlap = columns_->input(SCREE_OVERLAP, 0, i)};
  if (!touches(i)) return state;
  const int sliding = law_.instance().sliding_column;
  const bool slides = sliding >= 0 && columns_->history(std::size_t(sliding), i) > 0;
  state.status = slides ? PairStatus::slides : PairStatus::sticks;
  const Eigen::Vector3d normal = geometries_[i].normal;
  const Vec3 output = columns_->output_vector(SCREE_FORCE, i);
  const Eigen::Vector3d force(output[0], output[1], geometries_[i].dimension == 2 ? 0 : output[2]);
  const double along = force.dot(normal);
  state.mobilised = (force - along * normal).norm() / std::abs(along);
  return state;
}

void PairsOfLaw::evaluate(const StaticConfiguration& after, const StaticMotion& motion, StaticLoads& loads) {
  largest_force_ = 0;
  columns_.emplace(pairs_.size(), partner_);
  geometries_.clear();
  places_.clear();
  next_history_.assign(history_.size(), 0.0);
  next_states_.assign(pairs_.size(), {});
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const PairPlace& at = places_.emplace_back(simulation_, pairs_[i], after, motion);
    fill(i, at, after, motion);
    geometries_.push_back(at.geometry(simulation_.dimension(), spins_, arms_of(law_)));
  }
  columns_->evaluate(law_, duration);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    next_states_[i] = state_of(i);
    if (!touches(i)) continue;
    for (std::uint32_t k = 0; k < width(); ++k) next_history_[i * width() + k] = columns_->history(k, i);
    add_loads(i, loads);
  }
}

void PairsOfLaw::add_stiffness(Entries& stiffness) {
  std::vector<PairVariation> variations((pairs_.size() / SCREE_LANES + 1) * SCREE_LANES);
  std::vector<double> jacobian;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    variations[i] = places_[i].change;
    for (std::uint32_t k = 0; k < width(); ++k) columns_->history(k, i) = history_[i * width() + k];
  }
  jacobian_.evaluate(columns_->batch(duration), variations, jacobian);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (!touches(i)) continue;
    const ContactGeometry& of = geometries_[i];
    const Vec3 force = columns_->output_vector(SCREE_FORCE, i);
    const Eigen::Vector3d f(force[0], force[1], of.dimension == 2 ? 0 : force[2]);
    const SlipDerivative slip = places_[i].slip_derivative(arms_of(law_));
    Block block = of.of_bodies(of.displacements(jacobian_, jacobian.data(), i, slip), f);
    // Laws may use velocity × duration as the displacement of the increment; dashpots are round-off.
    block +=
        1 / duration * of.of_bodies(of.velocities(jacobian_, jacobian.data(), i), Eigen::Vector3d::Zero());
    stiffness.add({pairs_[i].a, pairs_[i].b}, block);
  }
}

void PairsOfLaw::commit() {
  history_.swap(next_history_);
  states_.swap(next_states_);
}

void PairsOfLaw::mark_touched(std::vector<bool>& touched) const {
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (next_states_[i].status != PairStatus::open) touched[pairs_[i].a] = touched[pairs_[i].b] = true;
}

void PairsOfLaw::append_touching(std::vector<ContactHistory>& all) const {
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (states_[i].status != PairStatus::open)
      all.push_back({pairs_[i].a, pairs_[i].b, std::span(history_).subspan(i * width(), width())});
}

}  // namespace scree::response
