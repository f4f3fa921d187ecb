#include "motion/motion.hpp"
#include "ranks/rank_vote.hpp"
#include "step/simulation_parts.hpp"
#include "step/stepper.hpp"

#include <algorithm>

// What a step does for each part of the bodies, and the sums over all parts.
namespace scree {

void Stepper::add_work_of_begun_step() {
  if (!parts_.driven.any() || !parts_.scene.audit) return;
  RankSums sums(parts_.ranks());
  PartSums all;
  add_total(all, sums);
  sums.close();
  parts_.audit.add_work(all.work_to_begin);
}

double Stepper::largest_of_parts() const {
  double largest = 0;
  for (const PartSums& sums : part_sums_) largest = std::max(largest, sums.square_speed);
  return largest;
}

Stepper::PartSums Stepper::total_of_tile(std::size_t tile) const {
  PartSums sums;
  tiles_.each_part(tile, [&](std::size_t part) { sums.add(part_sums_[part]); });
  return sums;
}

void Stepper::add_total(PartSums& all, RankSums& sums) const {
  if (tiles_.count() == 1 && !sums.over_ranks()) {
    all = total_of_tile(0);
    return;
  }
  std::vector<PartSums> tiles;
  for (std::size_t tile = 0; tile < tiles_.count(); ++tile) tiles.push_back(total_of_tile(tile));
  const auto add = [&](double& target, const auto& term) { sums.sum(target, tiles, term); };
  for (double BodySums::*const member : {&BodySums::potential, &BodySums::dissipation_rate_translation,
                                         &BodySums::dissipation_rate_rotation, &BodySums::work})
    add(all.bodies.*member, [&](const PartSums& tile) { return tile.bodies.*member; });
  for (int k = 0; k < 3; ++k)
    add(all.momentum.force[k], [&](const PartSums& tile) { return tile.momentum.force[k]; });
  add(all.momentum.magnitude, [](const PartSums& tile) { return tile.momentum.magnitude; });
  add(all.work, [](const PartSums& tile) { return tile.work; });
  add(all.work_to_begin, [](const PartSums& tile) { return tile.work_to_begin; });
  for (const PartSums& tile : tiles) all.finite &= tile.finite;
  sums.all(all.finite);
}

bool Stepper::evaluate_forces(double elapsed, const Moves& moves) {
  SimulationParts& p = parts_;
  p.forget_copies();
  bodies_advanced_ = moves.begin.has_value();
  if (moves.finish)
    evaluated_at_ = clock_after_substep(*moves.finish, elapsed).force_time;
  else
    evaluated_at_ = elapsed != 0 ? time_ : force_time_;
  RankSums sums(p.ranks());
  RankVote vote(p.share ? &*p.share : nullptr, p.boundaries);
  p.forces.evaluate(
      {.particles = p.particles,
       .contacts = p.contacts,
       .laws = p.laws,
       .planes = p.boundaries.planes(),
       .loads = p.boundaries.loads(),
       .surfaces = p.boundaries.surfaces(),
       .frame_loads = p.boundaries.frame_loads(),
       .domain = p.boundaries.domain(),
       .elapsed = elapsed,
       .kick = moves.finish.value_or(0)},
      *p.threads,
      // Two pointers: std::function stores them without an allocation.
      [this, &moves](std::size_t part, unsigned worker) {
        finish_part(part, moves, worker == 0 ? parts_.profile : nullptr);
      },
      sums, p.contact_sums, p.profile);
  PartSums all;
  add_total(all, sums);
  begun_square_speed_ = largest_of_parts();
  sums.largest(begun_square_speed_);
  vote.add_to(sums);
  sums.close();
  vote.conclude();
  p.body_sums = all.bodies;
  if (p.driven.any() && p.scene.audit) p.audit.add_work(all.work);
  p.momentum_audit.add_step(elapsed, all.momentum, p.boundaries.loads(), p.boundaries.surfaces().loads);
  return all.finite;
}

void Stepper::finish_part(std::size_t part, const Moves& moves, Profile* profile) {
  SimulationParts& p = parts_;
  Laps laps(profile);
  const BodyRange bodies = tiles_.part(part);
  PartSums& sums = part_sums_[part] = {};
  sums.momentum.add(p.particles, bodies);
  laps.lap(Profile::audit);
  p.body_forces.apply({evaluated_at_, force_time_}, p.particles, p.boundaries.domain(), bodies, sums.bodies);
  laps.lap(Profile::body_forces);
  if (p.driven.any_in(part)) {
    move_driven(part, bodies, moves, sums);
    return laps.lap(Profile::integrate);
  }
  if (moves.finish && moves.begin) {
    const auto moved = p.integrator->finish_and_begin_step(p.particles, *moves.finish, *moves.begin, bodies);
    sums.finite = moved.finite;
    sums.square_speed = moved.square_speed;
    Forces::clear(p.particles, bodies);
  } else if (moves.finish) {
    sums.finite = p.integrator->finish_step(p.particles, *moves.finish, bodies);
  }
  if (p.particles.orientations) rotate(bodies, moves);
  laps.lap(Profile::integrate);
}

void Stepper::rotate(BodyRange bodies, const Moves& moves) {
  const Particles& p = parts_.particles;
  Orientations& orientations = parts_.particles.orientations;
  const bool mid_step = parts_.integrator->evaluates_at_mid_step();
  // An integrator that evaluates forces at mid-step moves the bodies by half a step before and after it; each
  // half rotates by itself, so that the bits do not depend on whether the bodies are observed in between. If
  // the next step has begun, mid_spin is the spin at the end of this one.
  if (mid_step && moves.finish)
    orientations.rotate(moves.begin ? p.mid_spin() : p.spin(), 0.5 * *moves.finish, bodies.begin, bodies.end);
  if (moves.begin)
    orientations.rotate(p.mid_spin(), (mid_step ? 0.5 : 1.0) * *moves.begin, bodies.begin, bodies.end);
}

}  // namespace scree
