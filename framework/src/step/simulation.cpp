#include "bodies/body_range.hpp"
#include "contacts/start_springs.hpp"
#include "ranks/rank_sums.hpp"
#include "step/branch.hpp"
#include "step/health.hpp"
#include "step/simulation_parts.hpp"
#include "surfaces/sliding_work.hpp"
#include "walls/enclosure.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/scene_record.hpp>
#include <scree/simulation.hpp>
#include <scree/state_hash.hpp>
#include <scree/state_transfer.hpp>
#include <scree/step_guard.hpp>
#include <scree/surface_checks.hpp>

namespace scree {

namespace {

// Laws, walls and body forces are called in too many places to name the one that breaks the interface.
[[noreturn]] void report_exception(const Simulation& s, const std::string& what) {
  std::vector<std::string> names;
  for (const Scene::Law& law : s.scene().laws) names.push_back(law.parameters.plugin().name);
  for (const Scene::Boundary& boundary : s.scene().boundaries)
    names.push_back(boundary.parameters.plugin().name);
  for (const Scene::BodyForce& force : s.scene().body_forces) names.push_back(force.parameters.plugin().name);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  throw Error("",
              fmt::format("one of the plug-ins {} threw an exception ({}) in step {}, at t = {:g} s",
                          fmt::join(names, ", "), what, s.steps() + 1, s.time()),
              "laws, walls and body forces must not throw", ExitStatus::blow_up);
}

template <class Step>
bool without_exception(const Simulation& s, const Step& step) {
  try {
    return step();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& exception) {
    report_exception(s, exception.what());
  } catch (...) {
    report_exception(s, "of unknown type");
  }
}

// Σ w v² over bodies, in order within each tile.
double sum_of_squares(const Vectors<const double>& v, Particles::Axes axes, const BodyColumn<double>& weight,
                      const std::optional<RankShare>& share) {
  const BodyTiles tiles(weight.size());
  std::vector<double> sums(tiles.count(), 0);
  for (std::size_t tile = 0; tile < sums.size(); ++tile)
    if (!share || share->owners.is_own(tile))
      for (int k = axes.first; k < axes.last; ++k)
        for (std::size_t i = tiles[tile].begin; i < tiles[tile].end; ++i)
          sums[tile] += weight[i] * v[k][i] * v[k][i];
  double sum = 0;
  RankSums total(share ? &share->ranks : nullptr);
  total.sum(sum, sums, [](double of_tile) { return of_tile; });
  total.close();
  return sum;
}

}  // namespace

// Ranks find the pairs of their own bodies, but springs of a file need all pairs.
Simulation::Simulation(Scene scene, Ranks* ranks)
    : Simulation(std::make_unique<SimulationParts>(std::move(scene))) {
  SimulationParts& p = *parts_;
  check_sides(p.boundaries.surfaces(), p.particles);
  const bool share_early = ranks && p.scene.springs.empty();
  if (share_early) share_with(ranks);
  without_exception(*this, [&] { return p.find_and_evaluate_pairs(), start_springs(), true; });
  start_audits();
  check_health(p.stepper.initial_state_is_sound());
  if (!share_early) share_with(ranks);
}

Simulation::Simulation(const Scene& scene, const State& state, Ranks* ranks) {
  const StateTransfer from = StateTransfer::restoring_from(state);
  check_scene(state, scene);
  parts_ = std::make_unique<SimulationParts>(scene);
  parts_->transfer(from);
  std::uint64_t hash = 0;
  from.value("state_hash", "", hash);
  if (hash != StateHash::unknown && hash != state_hash())
    from.refuse("state_hash", "is not that of the numbers in the state");
  share_with(ranks);
}

Simulation::Simulation(const Scene& scene, const State& state, const Branching& branching, Ranks* ranks) {
  Branch branch(scene, state, branching);
  parts_ = std::make_unique<SimulationParts>(branch.scene());
  without_exception(*this, [&] { return branch.take_over(*this, *parts_), true; });
  parts_->taken_over = branch.report();
  parts_->let_go = branch.let_go();
  without_exception(*this, [&] { return start_springs(), true; });
  start_audits();
  check_health(parts_->stepper.initial_state_is_sound());
  share_with(ranks);
}

constexpr double smallest_cut = 1e-6;  // of an energy; round-off is less

// The first evaluation has set all else that laws keep, such as the radius of a contact; the second one cuts
// the springs at the limit of friction.
void Simulation::start_springs() {
  SimulationParts& p = *parts_;
  if (p.scene.springs.empty()) return;
  const StartSprings springs =
      place_springs(p.scene.springs, contact_list(), p.laws, dimension(), p.contacts, p.particles.order());
  p.stepper.reevaluate_forces(0);
  const double cut = p.contact_sums.dissipated_friction + p.contact_sums.dissipated_release;
  p.audit.add_lost(p.contact_sums);
  p.taken_over.push_back("springs of " + counted(springs.placed, "contact"));
  if (cut > smallest_cut * p.contact_sums.elastic_tangential)
    p.let_go.push_back(fmt::format(
        "friction cuts springs of the file, which loses {:.3g} J, in dissipated_friction of the probe "
        "energy; check springs.factor and the friction of the laws",
        cut));
  const auto lost = [&](std::size_t number, const char* why) {
    if (number > 0) p.let_go.push_back(counted(number, "spring") + " of the file lost, " + why);
  };
  lost(
      springs.apart,
      "since the bodies do not touch, are both fixed, or their law is absent; write positions and springs at the "
      "same step, with all digits");
  lost(springs.without_room,
       "since the law has no such springs; use one with friction that has them, such as "
       "linear_spring_dashpot or hertz_mindlin");
}

void Simulation::start_audits() {
  SimulationParts& p = *parts_;
  p.audit.set_stored(p.contact_sums, p.body_sums);
  const scree_energy now = energy();
  p.audit.start(now.kinetic_translation, now.kinetic_rotation, p.boundaries.energy());
}

void Simulation::advance(bool observed, const std::function<void(double)>* after_substep) {
  SimulationParts& p = *parts_;
  p.forget_copies();
  p.command(after_substep ? RankCommand::step_by_substeps
            : observed    ? RankCommand::step_observed
                          : RankCommand::step_followed);
  const std::function<void(double)> then_go_on = [&](double length) {
    (*after_substep)(length);
    p.command(RankCommand::go_on);
  };
  check_health(without_exception(*this, [&] {
    return p.stepper.step(observed ? Stepper::Next::observed : Stepper::Next::follows,
                          after_substep ? &then_go_on : nullptr);
  }));
}

void Simulation::step() { advance(true); }
void Simulation::step(const std::function<void(double length)>& after_substep) {
  advance(true, &after_substep);
}

std::uint64_t Simulation::run(std::uint64_t steps, const std::function<bool()>& proceed) {
  std::uint64_t taken = 0;
  for (bool more = steps > 0; more;) {
    more = ++taken < steps && proceed();
    advance(!more);
  }
  return taken;
}

void Simulation::check_health(bool sound) const {
  if (!sound) report_blow_up(*this, parts_->speed_limit);
}

void Simulation::measure(Profile* profile) { parts_->profile = profile; }

int Simulation::dimension() const { return parts_->scene.dimension; }
double Simulation::time() const { return parts_->stepper.time(); }
double Simulation::step_length() const { return parts_->scene.step; }
std::uint64_t Simulation::steps() const { return parts_->stepper.steps(); }
const Scene& Simulation::scene() const { return parts_->scene; }
const Particles& Simulation::particles() const { return parts_->in_scene_order(); }
const Particles& Simulation::particles(const std::vector<std::uint32_t>& numbers) const {
  return parts_->in_scene_order(numbers);
}
const Domain& Simulation::domain() const { return parts_->boundaries.domain(); }
const std::vector<scree_plane>& Simulation::planes() const { return parts_->boundaries.planes(); }
const std::vector<scree_load>& Simulation::loads() const { return parts_->boundaries.loads(); }
const std::vector<std::string>& Simulation::plane_names() const { return parts_->boundaries.plane_names(); }
const std::vector<std::uint8_t>& Simulation::absent_walls() const { return parts_->boundaries.absent(); }
const std::vector<std::uint32_t>& Simulation::plane_materials() const {
  return parts_->boundaries.plane_materials();
}
Vec3 Simulation::lengths() const { return enclosed_lengths(parts_->boundaries, dimension()); }
const Vec3& Simulation::lengths_at_start() const { return parts_->lengths_at_start; }
const std::vector<std::string>& Simulation::taken_over() const { return parts_->taken_over; }
const std::vector<std::string>& Simulation::let_go() const { return parts_->let_go; }
const Boundaries& Simulation::boundaries() const { return parts_->boundaries; }
double Simulation::surface_speed(std::size_t surface) const {
  return parts_->boundaries.surface_speed(surface, parts_->neighbours.surface_reach());
}
std::vector<double> Simulation::sliding_work(std::size_t surface) const {
  if (!parts_->forces.sliding_work()) return {};
  parts_->gather_sliding_work();
  return parts_->forces.sliding_work()->of(surface);
}
const BodyForces& Simulation::body_forces() const { return parts_->body_forces; }
void Simulation::add_body_forces(scree_body_batch& batch) const { add_body_forces(batch, time()); }
void Simulation::add_body_forces(scree_body_batch& batch, double time) const {
  parts_->body_forces.apply({time, time}, batch);
}
const Contacts& Simulation::contacts() const { return parts_->all_pairs().contacts; }

const std::string& Simulation::wall_name(std::size_t wall) const {
  return parts_->boundaries.wall_name(wall);
}
const WallSurfaces& Simulation::surfaces() const { return parts_->boundaries.surfaces(); }

WallEquations Simulation::linear_walls() const {
  return linear_walls(parts_->stepper.time(), planes(), surfaces().frames);
}
WallEquations Simulation::linear_walls(double time, const std::vector<scree_plane>& planes,
                                       const std::vector<scree_frame>& frames) const {
  return parts_->boundaries.linear_walls(time, planes, frames);
}

ContactList Simulation::listed_contacts(bool loaded) const {
  SimulationParts& p = *parts_;
  p.in_scene_order();  // before the bodies are read
  const auto [contacts, forces] = p.all_pairs();
  return touching_contacts({p.particles, contacts, forces, p.laws, p.boundaries},
                           loaded ? ListedPairs::touching_or_loaded : ListedPairs::touching);
}

ContactList Simulation::contact_list() const { return listed_contacts(false); }

ContactList Simulation::loaded_contact_list() const { return listed_contacts(true); }

double Simulation::contact_history(std::size_t pair, std::uint32_t column) const {
  for (const PairGroup& group : contacts().groups())
    if (pair >= group.begin && pair < group.end)
      return column < group.history_width ? group.history_of(pair, column) : 0;
  return 0;
}

scree_energy Simulation::energy() const {
  parts_->command(RankCommand::sum_energies);
  const Particles& p = parts_->particles;
  // Velocities at the time at which the stored energies were evaluated.
  const bool at_end = parts_->stepper.forces_at() == Stepper::ForcesAt::end_of_step;
  const auto velocity = at_end ? p.velocity() : p.mid_velocity();
  const auto spin = at_end ? p.spin() : p.mid_spin();
  const std::optional<RankShare>& share = parts_->share;
  const double translation = sum_of_squares(velocity, p.axes(), p.mass, share);
  const double rotation = sum_of_squares(spin, p.spin_axes(), p.inertia, share);
  return parts_->audit.balance(0.5 * translation, 0.5 * rotation, parts_->boundaries.energy());
}

double Simulation::energy_residual() const {
  if (!parts_->scene.audit) return 0;
  const scree_energy e = energy();
  return parts_->audit.share(std::abs(e.residual), e);
}

double Simulation::energy_created() const {
  const scree_energy e = energy();
  return parts_->audit.share(e.created, e);
}

double Simulation::momentum_residual() const { return parts_->momentum_audit.residual(); }
double Simulation::max_overlap_ratio() const { return parts_->contact_sums.max_overlap_ratio; }
std::uint64_t Simulation::rebuilds() const { return parts_->neighbours.rebuilds(); }
double Simulation::skin() const { return parts_->neighbours.skin(); }
double Simulation::first_skin() const { return parts_->neighbours.first_skin(); }

double Simulation::min_steps_per_contact() const {
  const Scene& scene = parts_->scene;
  const double impact_speed = 2 * std::max(0.0, parts_->stepper.max_speed() - norm(drift_velocity(scene)));
  return shortest_contact_time(scene, std::max(expected_speed(scene), impact_speed)) / scene.step;
}

Footprint Simulation::footprint() const {
  const Particles& p = parts_->particles;
  parts_->command(RankCommand::count_pairs);
  const auto [listed, touching, bytes_per_pair, crossing, foreign, sent] = parts_->count_pairs();
  std::uint32_t width = 0;
  for (const LawInstance& law : parts_->laws) width = std::max(width, law.interface.history_width);
  const std::size_t spins = std::size_t(p.spin_axes().last - p.spin_axes().first);
  const auto fixed = std::size_t(std::count(p.fixed.begin(), p.fixed.end(), 1));
  const auto held = p.held.size() - std::size_t(std::count(p.held.begin(), p.held.end(), 0));
  std::size_t held_components = 0;
  for (const freedom::Mask mask : p.held)
    held_components += std::size_t(std::popcount(freedom::Mask(mask & p.components())));
  return {.degrees_of_freedom = (p.size() - fixed) * (std::size_t(dimension()) + spins) - held_components,
          .fixed_bodies = fixed,
          .held_bodies = held,
          .bytes_per_body = p.bytes_per_body(),
          .bytes_per_pair = bytes_per_pair + width * sizeof(double),
          .history_width = width,
          .listed_pairs = listed,
          .touching_pairs = touching,
          .crossing_share = crossing.share(),
          .foreign_bodies = foreign,
          .bytes_sent = sent,
          .by_graph = parts_->share && parts_->share->owners.by_graph()};
}

}  // namespace scree
