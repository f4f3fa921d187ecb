#include "equilibrium/pairs_of_law.hpp"

#include "assembly/contact_terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <scree/plugin/great_circle.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree::response {

namespace {

// Duration of an increment (s) for the dashpots of the laws: so long that their forces are round-off.
constexpr double duration = 1e15;

scree_arms arms_of(const ConfiguredLaw& law) { return scree_arms(law.instance().arms); }

auto order(const StaticPair& p) { return std::tie(p.a, p.b); }

// Among the spots of the same body and mesh that were listed directly before.
std::uint32_t number_of_spot(const std::vector<ContactHistory>& before, const StaticPair& pair) {
  const bool follows = !before.empty() && before.back().a == pair.a && before.back().b == pair.b;
  return pair.spot && follows ? before.back().spot_number + 1 : 0;
}

}  // namespace

PairsOfLaw::PairsOfLaw(const Simulation& simulation, std::uint32_t law, Partner partner, int spins)
    : simulation_(simulation),
      partner_(partner),
      law_(differentiable(simulation.scene().laws[law], simulation.dimension())),
      jacobian_(law_, simulation.dimension()),
      spins_(spins) {}

void PairsOfLaw::set_pairs(std::vector<StaticPair> pairs, double gap) {
  std::vector<double> history(pairs.size() * width(), 0.0);
  std::vector<PairState> states(pairs.size());
  for (std::size_t i = 0, k = 0; i < pairs.size(); ++i) {
    while (k < pairs_.size() && order(pairs_[k]) < order(pairs[i])) ++k;
    const std::optional<std::size_t> before = former(pairs[i], k);
    if (!before) continue;
    std::copy_n(history_.begin() + std::ptrdiff_t(*before * width()), width(),
                history.begin() + std::ptrdiff_t(i * width()));
    states[i] = states_[*before];
  }
  pairs_ = std::move(pairs);
  history_ = std::move(history);
  states_ = std::move(states);
  gap_ = gap;
}

std::optional<std::size_t> PairsOfLaw::former(const StaticPair& pair, std::size_t first) const {
  constexpr double least_cosine = 0.94;  // of the angle between two normals of one spot
  std::optional<std::size_t> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = first; k < pairs_.size() && order(pairs_[k]) == order(pair); ++k) {
    if (!pair.spot || !pairs_[k].spot) return k;
    const double away = norm(pairs_[k].spot->point - pair.spot->point);
    if (!(dot(pairs_[k].spot->normal, pair.spot->normal) > least_cosine) || away >= nearest) continue;
    best = k, nearest = away;
  }
  return best;
}

void PairsOfLaw::set_history(std::uint32_t a, std::uint32_t b, const Vec3& normal,
                             const std::vector<double>& history, bool sliding) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].a != a || pairs_[i].b != b) continue;
    if (!best ||
        (pairs_[i].spot && dot(normal_of(pairs_[i]), normal) > dot(normal_of(pairs_[*best]), normal)))
      best = i;
  }
  if (!best) return;
  std::copy_n(history.begin(), width(), history_.begin() + std::ptrdiff_t(*best * width()));
  states_[*best].status = sliding ? PairStatus::slides : PairStatus::sticks;
}

Vec3 PairsOfLaw::normal_of(const StaticPair& pair) const {
  const std::size_t walls = simulation_.particles().size() + simulation_.planes().size();
  return rotation_of(simulation_.surfaces().frames[pair.b - walls])(pair.spot->normal);
}

std::size_t PairsOfLaw::end_of_spots(std::size_t begin) const {
  std::size_t end = begin + 1;
  while (end < pairs_.size() && order(pairs_[end]) == order(pairs_[begin])) ++end;
  return end;
}

void PairsOfLaw::add_places(std::size_t begin, std::size_t end, const StaticConfiguration& after,
                            const StaticMotion& motion) {
  const StaticPair& first = pairs_[begin];
  if (!first.spot) {
    places_.emplace_back(simulation_, first, after, motion);
    return;
  }
  const std::size_t walls = simulation_.particles().size() + simulation_.planes().size();
  const double radius = simulation_.particles().radius()[first.a];
  const BodyAtSurface body = {first.b - walls, simulation_.dimension(),
                              after.position[first.a] - after.position[first.b] + first.shift, radius,
                              law_.instance().follows_surfaces != 0};
  std::vector<SurfaceSpot> spots;
  for (std::size_t i = begin; i < end; ++i) spots.push_back(*pairs_[i].spot);
  const auto now = places_after(simulation_.surfaces(), body, radius + gap_, spots);
  for (std::size_t i = begin; i < end; ++i) {
    const MeshContact contact = {now[i - begin], states_[i].status != PairStatus::open};
    places_.emplace_back(simulation_, pairs_[i], after, motion, &contact);
  }
}

void PairsOfLaw::fill_history(std::size_t i) {
  for (std::uint32_t k = 0; k < width(); ++k) columns_->history(k, i) = history_[i * width() + k];
  if (!places_[i].spot || !keeps_spring(law_.instance(), simulation_.dimension())) return;
  Vec3 spring;
  for (int k = 0; k < 3; ++k) spring[k] = columns_->history(std::size_t(k), i);
  spring = turned_between(spring, normal_of(pairs_[i]), places_[i].normal);
  for (int k = 0; k < 3; ++k) columns_->history(std::size_t(k), i) = spring[k];
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
  fill_history(i);
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
  for (std::size_t i = 0, end; i < pairs_.size(); i = end)
    end = end_of_spots(i), add_places(i, end, after, motion);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    fill(i, places_[i], after, motion);
    geometries_.push_back(places_[i].geometry(simulation_.dimension(), spins_, arms_of(law_)));
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
    fill_history(i);
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
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (places_[i].spot) pairs_[i].spot = places_[i].spot;
}

void PairsOfLaw::mark_touched(std::vector<bool>& touched) const {
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (next_states_[i].status != PairStatus::open) touched[pairs_[i].a] = touched[pairs_[i].b] = true;
}

void PairsOfLaw::append_touching(std::vector<ContactHistory>& all) const {
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (states_[i].status != PairStatus::open)
      all.push_back({pairs_[i].a, pairs_[i].b, std::span(history_).subspan(i * width(), width()),
                     pairs_[i].spot, number_of_spot(all, pairs_[i])});
}

}  // namespace scree::response
