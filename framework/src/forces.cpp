#include "kernel/block.hpp"
#include "kernel/evaluate.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

#include <scree/forces.hpp>

namespace scree {

struct Forces::Work {
  // For each thread. With fewer, the first threads would have the settling of their tiles to do beside
  // contacts while the last wait for them.
  static constexpr std::size_t tiles_to_settle_at_once = 8;

  explicit Work(const Features& features)
      : evaluate(kernel::tile_evaluation(features)), constants(features.precision) {}

  kernel::EvaluateTile evaluate;
  std::uint64_t revision = 0;  // of the contacts that the following belongs to
  kernel::Tiles tiles;
  kernel::PlaneRecords planes;
  PairConstants constants;
  std::vector<ContactSums> block_sums;
  // Of each tile: how many of those that reach it are still to be evaluated; `settled` once somebody has
  // taken it on.
  std::unique_ptr<std::atomic<std::uint32_t>[]> awaited;
  static constexpr std::uint32_t settled = ~0u;

  // Evaluates all tiles, and settles the parts of each when those that reach it have been: at once, while its
  // bodies are in the cache of the thread, or in a second round. In a scene of few tiles, where one that is
  // late would hold up all others, all parts are shared out anew.
  template <class Evaluate, class SettlePart>
  void share_out(ThreadPool& threads, const Evaluate& evaluate_tile, const SettlePart& settle_part) {
    const std::size_t count = tiles.tiles().size();
    if (count < tiles_to_settle_at_once * threads.size()) {
      threads.each(count, evaluate_tile);
      return threads.each(tiles.bodies().parts(), settle_part);
    }
    for (std::size_t tile = 0; tile < count; ++tile)
      awaited[tile].store(tiles.tiles()[tile].reached_by, std::memory_order_relaxed);
    const auto settle_if_ready = [&](std::size_t tile, unsigned worker) {
      std::uint32_t nobody = 0;
      if (awaited[tile].compare_exchange_strong(nobody, settled, std::memory_order_acq_rel))
        tiles.bodies().each_part(tile, [&](std::size_t part) { settle_part(part, worker); });
    };
    threads.each(count, [&](std::size_t tile, unsigned worker) {
      evaluate_tile(tile, worker);
      for (const std::uint32_t reached : tiles.tiles()[tile].reached)
        awaited[reached].fetch_sub(1, std::memory_order_acq_rel);
      settle_if_ready(tile, worker);
    });
    threads.each(count, settle_if_ready);
  }
  double deepest = 0;  // overlap ratio met so far
};

ContactSums& ContactSums::operator+=(const ContactSums& other) {
  elastic_normal += other.elastic_normal;
  elastic_tangential += other.elastic_tangential;
  dissipated_normal += other.dissipated_normal;
  dissipated_tangential += other.dissipated_tangential;
  dissipated_rolling += other.dissipated_rolling;
  dissipated_friction += other.dissipated_friction;
  dissipated_release += other.dissipated_release;
  created_power += other.created_power;
  created += other.created;
  max_overlap_ratio = std::max(max_overlap_ratio, other.max_overlap_ratio);
  return *this;
}

Forces::Forces(const Features& features) : features_(features), work_(std::make_unique<Work>(features)) {}
Forces::~Forces() = default;

namespace {

std::array<double, 4 * 27> image_shifts(const Domain& domain) {
  std::array<double, 4 * 27> shifts = {};
  for (std::size_t code = 0; code < 27; ++code)
    for (int k = 0; k < 3; ++k) shifts[4 * code + std::size_t(k)] = domain.shift(std::uint8_t(code))[k];
  return shifts;
}

// Inputs that any law reads, and what these are made of.
std::uint32_t reads_of(const std::vector<LawInstance>& laws) {
  std::uint32_t reads = 0;
  for (const LawInstance& law : laws) reads |= law.interface.reads;
  if (reads & (1u << SCREE_CONTACT_RADIUS)) reads |= 1u << SCREE_EFFECTIVE_RADIUS;
  return reads;
}

ContactSums add_up(const std::vector<ContactSums>& blocks) {
  ContactSums total;
  for (const ContactSums& block : blocks) total += block;
  return total;
}

}  // namespace

void Forces::follow_pairs(Particles& particles, const Contacts& contacts, std::uint32_t reads,
                          std::size_t planes) {
  Work& w = *work_;
  if (w.revision == contacts.revision()) return;
  w.revision = contacts.revision();
  if (w.tiles.bodies().size() != particles.size()) w.tiles = kernel::Tiles(particles.size());
  w.tiles.plan(contacts, planes);
  w.constants.update(contacts, particles, reads, features_.pair_forces);
  particles.set_load_rows(w.tiles.slots());
  w.block_sums.resize(w.tiles.blocks().size());
  w.awaited = std::make_unique<std::atomic<std::uint32_t>[]>(w.tiles.tiles().size());
}

void Forces::clear(Particles& particles, BodyRange bodies) {
  const std::size_t width = particles.load_width();
  std::fill(particles.loads() + bodies.begin * width, particles.loads() + bodies.end * width, 0.0);
}

ContactSums Forces::evaluate(Particles& particles, Contacts& contacts, const std::vector<LawInstance>& laws,
                             const std::vector<scree_plane>& planes, std::vector<scree_load>& loads,
                             const Domain& domain, double step, ThreadPool& threads, const Settle& settle,
                             Profile* profile) {
  Work& w = *work_;
  follow_pairs(particles, contacts, reads_of(laws), planes.size());
  w.planes.set(planes, particles.width());
  alignas(32) std::array<double, 4 * 27> shifts;
  if (features_.periodic) shifts = image_shifts(domain);
  const kernel::Scene scene{contacts,        particles.records(),   w.planes,
                            shifts.data(),   features_.periodic,    step,
                            features_.audit, features_.pair_forces, w.deepest};
  const auto evaluate_tile = [&](std::size_t tile, unsigned worker) {
    w.evaluate({&scene, &w.tiles, tile, &contacts.groups(), laws.data(), &w.constants, particles.loads(),
                w.block_sums.data(), worker == 0 ? profile : nullptr});
  };
  const auto settle_part = [&](std::size_t part, unsigned worker) {
    Laps laps(worker == 0 ? profile : nullptr);
    collect(particles, part);
    laps.lap(Profile::reduce);
    settle(part, worker);
  };
  if (threads.size() > 1)
    w.share_out(threads, evaluate_tile, settle_part);
  else  // Pairs are in the order of a < b: no later tile looks at the bodies of this one.
    for (std::size_t tile = 0; tile < w.tiles.tiles().size(); ++tile) {
      evaluate_tile(tile, 0);
      w.tiles.bodies().each_part(tile, [&](std::size_t part) { settle_part(part, 0); });
    }
  sum_loads(particles, loads);
  ContactSums sums = add_up(w.block_sums);
  w.deepest = sums.max_overlap_ratio = std::max(w.deepest, sums.max_overlap_ratio);
  return sums;
}

void Forces::collect(Particles& particles, std::size_t part) const {
  const std::size_t width = particles.load_width();
  double* const loads = particles.loads();
  for (const kernel::Tiles::Incoming& in : work_->tiles.incoming(part))
    for (std::size_t k = 0; k < width; k += 4)
      kernel::add_four(loads + in.body * width + k, kernel::load_four(loads + in.slot * width + k));
}

void Forces::sum_loads(const Particles& particles, std::vector<scree_load>& loads) const {
  const kernel::Tiles& tiles = work_->tiles;
  const std::size_t width = particles.load_width();
  for (std::size_t plane = 0; plane < loads.size(); ++plane) {
    kernel::Four sum = {};
    for (std::size_t tile = 0; tile < tiles.tiles().size(); ++tile)
      sum += kernel::load_four(particles.loads() + tiles.plane_slot(tile, plane) * width);
    loads[plane] = {sum[0], sum[1], features_.dimension == 3 ? sum[2] : 0};
  }
}

Vec3 Forces::pair_force(std::size_t p) const {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (!features_.pair_forces) return {{unknown, unknown, unknown}};
  Vec3 force = {};
  for (int k = 0; k < features_.dimension; ++k) force[k] = work_->constants.force.value(std::uint32_t(k), p);
  return force;
}

std::size_t Forces::bytes_per_pair() const {
  return work_->constants.bytes_per_pair() + 4 * sizeof(std::uint32_t) + sizeof(std::uint8_t);
}

}  // namespace scree
