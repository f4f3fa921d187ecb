#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/energy.hpp>
#include <scree/until.hpp>

namespace scree {

namespace {

struct KineticEnergy {
  double translation, rotation;
  double sum() const { return translation + rotation; }
};

KineticEnergy kinetic_energy_of(const Body& b) {
  return {0.5 * b.mass * dot(b.velocity, b.velocity), 0.5 * b.inertia * dot(b.spin, b.spin)};
}

// A body without the motion in which it is held, which no force ends.
Body body_that_comes_to_rest(const Particles& p, std::size_t i) {
  Body body = p.body(i);
  for (int k = 0; k < 3; ++k) {
    if (p.is_held(i, k)) body.velocity[k] = 0;
    if (p.is_held(i, freedom::first_rotation + k)) body.spin[k] = 0;
  }
  return body;
}

bool is_free(const Particles& p, std::size_t i) {
  const Vectors<const double> force = p.force();
  for (int k = 0; k < p.dimension(); ++k)
    if (force[k][i] != 0) return false;
  return true;
}

// Contacts of a body, and the normal of the last of them.
struct Support {
  int contacts = 0;
  Vec3 normal = {};
};

std::vector<Support> supports_of(const Simulation& simulation) {
  const ContactList list = simulation.contact_list();
  std::vector<Support> supports(simulation.particles().size());
  for (std::size_t k = 0; k < list.size(); ++k)
    for (const std::uint32_t body : {list.a[k], list.b[k]})
      if (body < supports.size()) {
        ++supports[body].contacts;
        supports[body].normal = {{list.normal[3 * k], list.normal[3 * k + 1], list.normal[3 * k + 2]}};
      }
  return supports;
}

// By spinning if nine tenths are of rotations; of bodies that touch something by rolling if a fifth or more
// is.
enum class Motion { flying, rolling, spinning, sliding };

Motion motion_of(const KineticEnergy& energy, bool touches) {
  const double share = energy.rotation / energy.sum();
  if (share > 0.9) return Motion::spinning;
  return !touches ? Motion::flying : share > 0.2 ? Motion::rolling : Motion::sliding;
}

Movers told(Motion motion) {
  switch (motion) {
    case Motion::flying:
      return {"in flight",
              "wait for them (at_most), or add translational drag (background_damping, translational)"};
    case Motion::rolling:
      return {"by rolling", "add rotational drag (background_damping, rotational) or rolling friction"};
    case Motion::spinning:
      return {"by spinning", "add rotational drag (background_damping, rotational)"};
    default:
      return {"by sliding or vibrating", "add damping or friction"};
  }
}

// The bodies with the most kinetic energy that hold the share; empty if they are more than `count`.
std::vector<std::size_t> holders(const std::vector<KineticEnergy>& energies, double share,
                                 std::size_t count) {
  std::vector<std::size_t> order(energies.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  count = std::min(count, order.size());
  std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(count), order.end(),
                    [&](std::size_t a, std::size_t b) { return energies[a].sum() > energies[b].sum(); });
  double all = 0, held = 0;
  for (const KineticEnergy& e : energies) all += e.sum();
  for (std::size_t n = 0; n < count; ++n) {
    held += energies[order[n]].sum();
    if (held < share * all) continue;
    order.resize(n + 1);
    return order;
  }
  return {};
}

}  // namespace

bool Until::reads_energies() const {
  return std::any_of(conditions.begin(), conditions.end(),
                     [](const Condition& c) { return c.probe == Condition::energies; });
}

bool Until::reads_columns() const {
  return std::any_of(conditions.begin(), conditions.end(),
                     [](const Condition& c) { return c.probe != Condition::energies; });
}

std::string Condition::wanted() const {
  std::vector<std::string> parts;
  if (above) parts.push_back(fmt::format("above {:g}", *above));
  if (below) parts.push_back(fmt::format("below {:g}", *below));
  if (steady) parts.push_back(fmt::format("steady within {:g} over {:g} s", *steady, over));
  return fmt::format("{}", fmt::join(parts, " and "));
}

std::string Until::text() const {
  std::vector<std::string> parts;
  for (const Condition& c : conditions) parts.push_back(c.name + " " + c.wanted());
  return fmt::format("{}", fmt::join(parts, any ? " or " : " and "));
}

void ConditionValues::take(double time, double value) {
  latest_ = value;
  if (!condition_->steady) return;
  recent_.emplace_back(time, value);
  // One value from before the time is kept, so that all of it is covered.
  while (recent_.size() > 2 && recent_[1].first <= time - condition_->over) recent_.pop_front();
}

double ConditionValues::change() const {
  double low = INFINITY, high = -INFINITY, size = 0;
  for (const auto& [time, value] : recent_) {
    if (std::isnan(value)) return NAN;
    low = std::min(low, value), high = std::max(high, value), size = std::max(size, std::abs(value));
  }
  return size > 0 ? (high - low) / size : INFINITY;  // of nothing there is no share
}

bool ConditionValues::met() const {
  if (!latest_) return false;
  const Condition& c = *condition_;
  if (c.above && !(*latest_ > *c.above)) return false;
  if (c.below && !(*latest_ < *c.below)) return false;
  if (!c.steady) return true;
  constexpr double round_off = 1e-9;
  const double covered = recent_.back().first - recent_.front().first;
  return covered >= c.over * (1 - round_off) && change() < *c.steady;
}

std::string ConditionValues::status() const {
  if (!latest_) return fmt::format("{}: no value so far, {}", condition_->name, condition_->wanted());
  const std::string unit = condition_->unit.empty() ? "" : " " + condition_->unit;
  return fmt::format("{} = {:.3g}{}, {}", condition_->name, *latest_, unit, condition_->wanted());
}

std::string ConditionValues::problem() const {
  if (!latest_) return fmt::format("{} has no value so far", condition_->name);
  const std::string unit = condition_->unit.empty() ? "" : " " + condition_->unit;
  std::string changes;
  if (condition_->steady && recent_.size() > 1)
    changes = std::isinf(change()) ? " and was 0 all the time, of which there is no share"
                                   : fmt::format(" and changes by {:.3g} of itself", change());
  return fmt::format("{} is {:.3g}{}{}, not {}", condition_->name, *latest_, unit, changes,
                     condition_->wanted());
}

void ConditionValues::transfer(const StateTransfer& state) {
  std::vector<double> latest, times, values;
  if (latest_) latest.push_back(*latest_);
  for (const auto& [time, value] : recent_) times.push_back(time), values.push_back(value);
  state.rows("latest", "", latest, 1, stored::any);
  state.rows("times", "s", times);
  values.resize(times.size());
  state.sized_rows("values", "", values, 1, stored::any);
  if (!state.restoring()) return;
  if (latest.size() > 1) state.refuse("latest", "has more than one value");
  latest_ = latest.empty() ? std::nullopt : std::optional(latest[0]);
  recent_.clear();
  for (std::size_t k = 0; k < times.size(); ++k) recent_.emplace_back(times[k], values[k]);
}

double kinetic_over_elastic(const Simulation& simulation) {
  const scree_energy energy = simulation.energy();
  const double elastic = elastic_energy(energy);
  if (!(elastic > 0)) return INFINITY;
  const Particles& p = simulation.particles();
  const std::vector<Support> supports = supports_of(simulation);
  if (std::none_of(supports.begin(), supports.end(), [](const Support& s) { return s.contacts > 1; }))
    return kinetic_energy(energy) / elastic;
  double kinetic = energy.kinetic_boundary;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Body body = body_that_comes_to_rest(p, i);
    if (supports[i].contacts == 1)
      kinetic += 0.5 * body.mass * std::pow(dot(body.velocity, supports[i].normal), 2);
    else if (supports[i].contacts > 1 || !is_free(p, i))
      kinetic += kinetic_energy_of(body).sum();
  }
  return kinetic / elastic;
}

std::optional<Movers> movers(const Simulation& simulation) {
  constexpr double share = 0.99;
  const Particles& p = simulation.particles();
  std::vector<KineticEnergy> kinetic;
  for (std::size_t i = 0; i < p.size(); ++i)
    kinetic.push_back(is_free(p, i) ? KineticEnergy{0, 0} : kinetic_energy_of(p.body(i)));
  const std::vector<std::size_t> few = holders(kinetic, share, std::max<std::size_t>(10, p.size() / 100));
  if (few.empty() || !(kinetic[few[0]].sum() > 0)) return std::nullopt;
  const std::vector<Support> supports = supports_of(simulation);
  KineticEnergy held{0, 0};
  bool any_touches = false;
  std::vector<std::string> names;
  for (const std::size_t i : few) {
    held.translation += kinetic[i].translation, held.rotation += kinetic[i].rotation;
    any_touches = any_touches || supports[i].contacts > 0;
    if (names.size() < 3) names.push_back(fmt::format("particle {}", p.body(i).id));
  }
  if (few.size() > names.size()) names.push_back("...");
  double all = 0;
  for (const KineticEnergy& e : kinetic) all += e.sum();
  const auto [how, cure] = told(motion_of(held, any_touches));
  return Movers{
      fmt::format("{} of {} ({}) {} {:.4g} % of the kinetic energy, {}", few.size(), p.size(),
                  fmt::join(names, ", "), few.size() == 1 ? "holds" : "hold", 100 * held.sum() / all, how),
      cure};
}

}  // namespace scree
