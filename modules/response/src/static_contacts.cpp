#include "static_contacts.hpp"

#include "contact_geometry.hpp"
#include "contact_terms.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <scree/contact_columns.hpp>
#include <scree/contact_jacobian.hpp>

namespace scree::response {

namespace {

// Time (s) that an increment takes, for the dashpots of the laws: long enough that their forces are round-off.
constexpr double duration = 1e15;

std::uint32_t material_of_plane(const Simulation& simulation, std::size_t plane) {
  const std::string& name = simulation.plane_names()[plane];
  for (const Scene::Boundary& boundary : simulation.scene().boundaries)
    if (name.starts_with(boundary.name + ".")) return boundary.material;
  return 0;
}

}  // namespace

// Pairs of one law.
class StaticContacts::LawPairs {
 public:
  LawPairs(const Simulation& simulation, std::uint32_t law, int spins)
      : simulation_(simulation),
        law_(differentiable(simulation.scene().laws[law], simulation.dimension())),
        jacobian_(law_, simulation.dimension()),
        law_number_(law),
        spins_(spins) {}

  // Pairs that were known, by (a, b), keep their histories; others begin without.
  void set_pairs(const std::vector<std::array<std::uint32_t, 2>>& pairs, const std::vector<Vec3>& shifts);
  void set_history(std::uint32_t a, std::uint32_t b, const std::vector<double>& history, bool sliding);
  void evaluate(const StaticConfiguration& after, const StaticMotion& motion, StaticLoads& loads);
  void add_stiffness(Entries& stiffness);
  void commit();

  std::uint32_t width() const { return law_.instance().history_width; }
  std::size_t events() const;
  std::size_t count(PairStatus status) const {
    return std::size_t(std::count(status_.begin(), status_.end(), status));
  }
  double largest_force() const { return largest_force_; }
  void append_touching(std::vector<Touching>& all) const;

 private:
  struct Pair {
    std::uint32_t a, b;
    Vec3 shift;  // (m) added to x_a − x_b of bodies
  };
  // Where a pair is at the end and in the middle of an increment.
  struct Place {
    Vec3 separation, normal, mid_normal;
    double distance, mid_distance, radius_a, radius_b;
  };

  bool is_wall(const Pair& pair) const { return pair.b >= bodies(); }
  bool touches(std::size_t i) { return columns_->input(SCREE_OVERLAP, 0, i) > 0; }
  std::size_t bodies() const { return simulation_.particles().size(); }
  Place place(const Pair& pair, const StaticConfiguration& after, const StaticMotion& motion) const;
  std::array<double, 2> arms(const Place& at, double distance) const;
  ContactGeometry geometry(const Pair& pair, const Place& at) const;
  void fill(ContactColumns& columns, std::size_t i, const Place& at, const StaticConfiguration& after,
            const StaticMotion& motion) const;
  void set_orientations(ContactColumns& columns, std::size_t i, const StaticConfiguration& after) const;
  void add_loads(const ContactColumns& columns, std::size_t i, const ContactGeometry& geometry,
                 StaticLoads& loads);
  PairStatus status_of(const ContactColumns& columns, std::size_t i);

  const Simulation& simulation_;
  ConfiguredLaw law_;
  ContactJacobian jacobian_;
  std::uint32_t law_number_;
  int spins_;
  std::vector<Pair> pairs_;
  std::vector<double> history_, next_history_;  // (pairs, width)
  std::vector<PairStatus> status_, next_status_;
  // Of the last evaluation.
  std::optional<ContactColumns> columns_;
  std::vector<ContactGeometry> geometries_;
  double largest_force_ = 0;
};

void StaticContacts::LawPairs::set_pairs(const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                         const std::vector<Vec3>& shifts) {
  const std::vector<Pair> known = std::move(pairs_);
  const std::vector<double> history = std::move(history_);
  const std::vector<PairStatus> status = std::move(status_);
  pairs_.clear();
  history_.assign(pairs.size() * width(), 0.0);
  status_.assign(pairs.size(), PairStatus::open);
  for (std::size_t i = 0, k = 0; i < pairs.size(); ++i) {
    const auto [a, b] = pairs[i];
    pairs_.push_back({a, b, shifts[i]});
    while (k < known.size() && std::pair(known[k].a, known[k].b) < std::pair(a, b)) ++k;
    if (k == known.size() || known[k].a != a || known[k].b != b) continue;
    std::copy_n(history.begin() + std::ptrdiff_t(k * width()), width(),
                history_.begin() + std::ptrdiff_t(i * width()));
    status_[i] = status[k];
  }
}

void StaticContacts::LawPairs::set_history(std::uint32_t a, std::uint32_t b,
                                           const std::vector<double>& history, bool sliding) {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].a != a || pairs_[i].b != b) continue;
    std::copy_n(history.begin(), width(), history_.begin() + std::ptrdiff_t(i * width()));
    status_[i] = sliding ? PairStatus::slides : PairStatus::sticks;
  }
}

StaticContacts::LawPairs::Place StaticContacts::LawPairs::place(const Pair& pair,
                                                                const StaticConfiguration& after,
                                                                const StaticMotion& motion) const {
  const Vec3 moved = motion.displacement[pair.a] - motion.displacement[pair.b];
  Place at = {.separation = after.position[pair.a] - after.position[pair.b] + pair.shift,
              .normal = {},
              .mid_normal = {},
              .distance = 0,
              .mid_distance = 0,
              .radius_a = simulation_.particles().radius()[pair.a],
              .radius_b = is_wall(pair) ? 0 : simulation_.particles().radius()[pair.b]};
  if (is_wall(pair)) {
    const scree_plane& plane = simulation_.planes()[pair.b - bodies()];
    for (int k = 0; k < 3; ++k) at.normal[k] = plane.normal[k];
    at.mid_normal = at.normal;
    at.distance = dot(at.separation, at.normal);
    at.mid_distance = at.distance - 0.5 * dot(moved, at.normal);
    return at;
  }
  const Vec3 middle = at.separation - 0.5 * moved;
  at.distance = norm(at.separation), at.mid_distance = norm(middle);
  at.normal = 1 / at.distance * at.separation;
  at.mid_normal = 1 / at.mid_distance * middle;
  return at;
}

std::array<double, 2> StaticContacts::LawPairs::arms(const Place& at, double distance) const {
  const bool to_contact_point = law_.instance().arms == SCREE_ARM_CONTACT_POINT;
  const double reach = to_contact_point ? distance : at.radius_a + at.radius_b;
  const double difference = at.radius_a - at.radius_b;
  return {0.5 * (reach + difference), at.radius_b > 0 ? 0.5 * (reach - difference) : 0};
}

ContactGeometry StaticContacts::LawPairs::geometry(const Pair& pair, const Place& at) const {
  const auto [arm_a, arm_b] = arms(at, at.distance);
  return {.dimension = simulation_.dimension(),
          .spins = spins_,
          .normal = Eigen::Map<const Eigen::Vector3d>(at.normal.component),
          .arm_a = arm_a,
          .arm_b = arm_b,
          .inverse_distance = is_wall(pair) ? 0 : 1 / at.distance,
          .arms_change = law_.instance().arms == SCREE_ARM_CONTACT_POINT};
}

void StaticContacts::LawPairs::fill(ContactColumns& columns, std::size_t i, const Place& at,
                                    const StaticConfiguration& after, const StaticMotion& motion) const {
  const Particles& p = simulation_.particles();
  const Pair& pair = pairs_[i];
  const Vec3 moved = motion.displacement[pair.a] - motion.displacement[pair.b];
  const auto slip = [&](const Vec3& normal, double distance) {
    const auto [arm_a, arm_b] = arms(at, distance);
    return moved + cross(normal, arm_a * motion.rotation[pair.a] + arm_b * motion.rotation[pair.b]);
  };
  const double overlap = at.radius_a + at.radius_b - at.distance, approach = -dot(moved, at.normal);
  const double touched = overlap < approach ? std::max(overlap, 0.0) / approach : 1;
  const Vec3 displaced = slip(at.mid_normal, at.mid_distance);
  columns.set(SCREE_NORMAL, at.normal, i);
  columns.input(SCREE_OVERLAP, 0, i) = overlap;
  columns.set(SCREE_RELATIVE_VELOCITY, 1 / duration * slip(at.normal, at.distance), i);
  columns.set(SCREE_TANGENTIAL_INCREMENT,
              touched * (displaced - dot(displaced, at.mid_normal) * at.mid_normal), i);
  const Vec3 turned = 1 / duration * (motion.rotation[pair.a] - motion.rotation[pair.b]);
  if (p.dimension() == 2)
    columns.input(SCREE_RELATIVE_SPIN, 0, i) = turned[2];
  else
    columns.set(SCREE_RELATIVE_SPIN, turned, i);
  columns.input(SCREE_REDUCED_MASS, 0, i) =
      1 / (p.inverse_mass()[pair.a] + (is_wall(pair) ? 0 : p.inverse_mass()[pair.b]));
  columns.input(SCREE_EFFECTIVE_RADIUS, 0, i) =
      is_wall(pair) ? at.radius_a : 1 / (1 / at.radius_a + 1 / at.radius_b);
  columns.input(SCREE_RADII, 0, i) = at.radius_a;
  columns.input(SCREE_RADII, 1, i) = at.radius_b;
  columns.set(SCREE_SEPARATION, at.separation, i);
  for (std::uint32_t k = 0; k < width(); ++k) columns.history(k, i) = history_[i * width() + k];
  set_orientations(columns, i, after);
}

void StaticContacts::LawPairs::set_orientations(ContactColumns& columns, std::size_t i,
                                                const StaticConfiguration& after) const {
  if (!(law_.instance().reads & (1u << SCREE_ORIENTATION_A))) return;
  const Pair& pair = pairs_[i];
  for (int k = 0; k < after.orientations.components(); ++k) {
    const double of_wall = after.orientations.components() > 1 && k == 0 ? 1 : 0;
    columns.input(SCREE_ORIENTATION_A, k, i) = after.orientations[k][pair.a];
    columns.input(SCREE_ORIENTATION_B, k, i) = is_wall(pair) ? of_wall : after.orientations[k][pair.b];
  }
}

void StaticContacts::LawPairs::add_loads(const ContactColumns& columns, std::size_t i,
                                         const ContactGeometry& geometry, StaticLoads& loads) {
  const bool flat = geometry.dimension == 2;
  Vec3 force = columns.output_vector(SCREE_FORCE, i), couple = {};
  if (flat) force[2] = 0;
  if (law_.instance().writes_couple) {
    couple = columns.output_vector(SCREE_COUPLE, i);
    if (flat) couple = {{0, 0, couple[0]}};
  }
  const Pair& pair = pairs_[i];
  const Vec3 lever = cross(Vec3{{geometry.normal[0], geometry.normal[1], geometry.normal[2]}}, force);
  loads.force[pair.a] += force;
  loads.force[pair.b] += -1.0 * force;
  loads.torque[pair.a] += couple - geometry.arm_a * lever;
  loads.torque[pair.b] += -1.0 * couple - geometry.arm_b * lever;
  largest_force_ = std::max(largest_force_, norm(force));
}

PairStatus StaticContacts::LawPairs::status_of(const ContactColumns& columns, std::size_t i) {
  const int sliding = law_.instance().sliding_column;
  return sliding >= 0 && columns.history(std::size_t(sliding), i) > 0 ? PairStatus::slides
                                                                      : PairStatus::sticks;
}

void StaticContacts::LawPairs::evaluate(const StaticConfiguration& after, const StaticMotion& motion,
                                        StaticLoads& loads) {
  largest_force_ = 0;
  columns_.emplace(pairs_.size());
  geometries_.clear();
  next_history_.assign(history_.size(), 0.0);
  next_status_.assign(pairs_.size(), PairStatus::open);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Place at = place(pairs_[i], after, motion);
    fill(*columns_, i, at, after, motion);
    geometries_.push_back(geometry(pairs_[i], at));
  }
  columns_->evaluate(law_, duration);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (!touches(i)) continue;
    for (std::uint32_t k = 0; k < width(); ++k) next_history_[i * width() + k] = columns_->history(k, i);
    next_status_[i] = status_of(*columns_, i);
    add_loads(*columns_, i, geometries_[i], loads);
  }
}

void StaticContacts::LawPairs::add_stiffness(Entries& stiffness) {
  std::vector<double> inverse_distance((pairs_.size() / SCREE_LANES + 1) * SCREE_LANES, 0.0), jacobian;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    inverse_distance[i] = geometries_[i].inverse_distance;
    for (std::uint32_t k = 0; k < width(); ++k) columns_->history(k, i) = history_[i * width() + k];
  }
  jacobian_.evaluate(columns_->batch(duration), inverse_distance.data(), jacobian);
  // Laws that integrate the spin by themselves; the dashpots of others are round-off.
  const bool by_spin = law_.instance().reads & (1u << SCREE_RELATIVE_SPIN);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (!touches(i)) continue;
    const ContactGeometry& of = geometries_[i];
    const Vec3 force = columns_->output_vector(SCREE_FORCE, i);
    const Eigen::Vector3d f(force[0], force[1], of.dimension == 2 ? 0 : force[2]);
    Block block = of.of_bodies(of.displacements(jacobian_, jacobian.data(), i), f);
    if (by_spin)
      block +=
          1 / duration * of.of_bodies(of.velocities(jacobian_, jacobian.data(), i), Eigen::Vector3d::Zero());
    stiffness.add({pairs_[i].a, pairs_[i].b}, block);
  }
}

void StaticContacts::LawPairs::commit() {
  history_.swap(next_history_);
  status_.swap(next_status_);
}

std::size_t StaticContacts::LawPairs::events() const {
  std::size_t changed = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) changed += status_[i] != next_status_[i];
  return changed;
}

void StaticContacts::LawPairs::append_touching(std::vector<Touching>& all) const {
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (status_[i] != PairStatus::open)
      all.push_back({pairs_[i].a, pairs_[i].b, law_number_, history_.data() + i * width(), width()});
}

StaticContacts::StaticContacts(const Simulation& simulation, int spins)
    : simulation_(simulation), spins_(spins) {
  for (std::uint32_t law = 0; law < simulation.scene().laws.size(); ++law)
    laws_.push_back(std::make_unique<LawPairs>(simulation, law, spins));
  find_pairs(StaticConfiguration(simulation), 0);
  const ContactList list = simulation.contact_list();
  for (std::size_t c = 0; c < list.size(); ++c) {
    LawPairs& law = *laws_[list.law[c]];
    std::vector<double> history;
    for (std::uint32_t k = 0; k < law.width(); ++k)
      history.push_back(simulation.contact_history(list.pair[c], k));
    law.set_history(list.a[c], list.b[c], history, list.sliding[c]);
  }
}

StaticContacts::~StaticContacts() = default;

void StaticContacts::find_pairs(const StaticConfiguration& at, double gap) {
  const Particles& p = simulation_.particles();
  const Domain& domain = simulation_.domain();
  const std::size_t materials = simulation_.scene().materials.size();
  std::vector<std::vector<std::array<std::uint32_t, 2>>> pairs(laws_.size());
  std::vector<std::vector<Vec3>> shifts(laws_.size());
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t material_b, const Vec3& shift) {
    const std::uint32_t law = simulation_.scene().law_of[p.material[a] * materials + material_b];
    pairs[law].push_back({a, b}), shifts[law].push_back(shift);
  };
  for (std::uint32_t a = 0; a < p.size(); ++a) {
    for (std::uint32_t b = a + 1; b < p.size(); ++b) {
      Vec3 apart = at.position[a] - at.position[b], shift = {};
      for (int k = 0; k < p.dimension(); ++k)
        if (domain.periodic[std::size_t(k)])
          shift[k] = -std::round(apart[k] / domain.length(k)) * domain.length(k);
      apart += shift;
      const double reach = p.radius()[a] + p.radius()[b] + gap;
      if (dot(apart, apart) <= reach * reach) add(a, b, p.material[b], shift);
    }
    for (std::size_t w = 0; w < simulation_.planes().size(); ++w) {
      const auto b = std::uint32_t(p.size() + w);
      const Vec3 apart = at.position[a] - at.position[b];
      double distance = 0;
      for (int k = 0; k < p.dimension(); ++k) distance += apart[k] * simulation_.planes()[w].normal[k];
      if (distance <= p.radius()[a] + gap) add(a, b, material_of_plane(simulation_, w), {});
    }
  }
  for (std::size_t law = 0; law < laws_.size(); ++law) laws_[law]->set_pairs(pairs[law], shifts[law]);
}

void StaticContacts::evaluate(const StaticConfiguration& after, const StaticMotion& motion,
                              StaticLoads& loads) {
  for (const auto& law : laws_) law->evaluate(after, motion, loads);
}

void StaticContacts::add_stiffness(Entries& stiffness) const {
  for (const auto& law : laws_) law->add_stiffness(stiffness);
}

void StaticContacts::commit() {
  for (const auto& law : laws_) law->commit();
}

std::size_t StaticContacts::events() const {
  std::size_t sum = 0;
  for (const auto& law : laws_) sum += law->events();
  return sum;
}

std::size_t StaticContacts::count(PairStatus status) const {
  std::size_t sum = 0;
  for (const auto& law : laws_) sum += law->count(status);
  return sum;
}

double StaticContacts::largest_force() const {
  double largest = 0;
  for (const auto& law : laws_) largest = std::max(largest, law->largest_force());
  return largest;
}

std::vector<StaticContacts::Touching> StaticContacts::touching() const {
  std::vector<Touching> all;
  for (const auto& law : laws_) law->append_touching(all);
  return all;
}

}  // namespace scree::response
