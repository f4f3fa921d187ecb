#include "contacts/forces.hpp"

#include "contacts/kernel/block.hpp"
#include "contacts/kernel/evaluate.hpp"
#include "contacts/tile_schedule.hpp"
#include "machine/exact_sum.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <scree/state_transfer.hpp>

namespace scree {

struct Forces::Work {
  explicit Work(const Features& features) : evaluate(kernel::tile_evaluation(features)) {}

  kernel::EvaluateTile evaluate;
  std::uint64_t revision = 0;  // of the contacts for which the members below were computed
  kernel::Tiles tiles;
  kernel::PlaneRecords planes;
  PairConstants constants;
  std::vector<ContactSums> tile_sums;
  TileSchedule schedule;
  double max_overlap_ratio = 0;  // largest so far
};

Forces::Forces(const Features& features) : features_(features), work_(std::make_unique<Work>(features)) {}
Forces::~Forces() = default;

namespace {

std::array<double, 4 * 27> image_shifts(const Domain& domain) {
  std::array<double, 4 * 27> shifts = {};
  for (std::size_t code = 0; code < 27; ++code)
    for (int k = 0; k < 3; ++k) shifts[4 * code + std::size_t(k)] = domain.shift(std::uint8_t(code))[k];
  return shifts;
}

}  // namespace

std::uint32_t reads_of(const std::vector<LawInstance>& laws) {
  std::uint32_t reads = 0;
  for (const LawInstance& law : laws) reads |= law.interface.reads;
  if (reads & (1u << SCREE_CONTACT_RADIUS)) reads |= 1u << SCREE_EFFECTIVE_RADIUS;
  return reads;
}

void Forces::update_pairs(Particles& particles, const Contacts& contacts, std::uint32_t reads,
                          std::size_t planes, ThreadPool& threads) {
  Work& work = *work_;
  if (work.revision == contacts.revision()) return;
  work.revision = contacts.revision();
  if (work.tiles.bodies().size() != particles.size()) work.tiles = kernel::Tiles(particles.size());
  work.tiles.plan(contacts, planes, threads);
  work.constants.update(contacts, particles, reads, features_.pair_forces, threads);
  particles.set_load_rows(work.tiles.slots());
  work.tile_sums.resize(work.tiles.tiles().size());
}

void Forces::clear(Particles& particles, BodyRange bodies) {
  const std::size_t width = particles.load_width();
  std::fill(particles.loads() + bodies.begin * width, particles.loads() + bodies.end * width, 0.0);
}

ContactSums Forces::evaluate(const Evaluation& e, ThreadPool& threads, const FinishPart& finish_part,
                             Profile* profile) {
  Work& work = *work_;
  Laps laps_of_search(profile);
  update_pairs(e.particles, e.contacts, reads_of(e.laws), e.planes.size(), threads);
  laps_of_search.lap(Profile::neighbours);
  work.planes.set(e.planes, e.particles.width());
  alignas(32) std::array<double, 4 * 27> shifts;
  if (features_.periodic) shifts = image_shifts(e.domain);
  const kernel::EvaluationInput input = {.contacts = e.contacts,
                                         .records = e.particles.records(),
                                         .particles = e.particles,
                                         .planes = work.planes,
                                         .domain = e.domain,
                                         .shifts = shifts.data(),
                                         .periodic = features_.periodic,
                                         .step = e.elapsed,
                                         .kick = e.kick,
                                         .audit = features_.audit,
                                         .pair_forces = features_.pair_forces,
                                         .max_overlap_ratio = work.max_overlap_ratio};
  work.schedule.run(
      work.tiles, threads,
      [&](std::size_t tile, unsigned worker) {
        work.evaluate({.input = &input,
                       .tiles = &work.tiles,
                       .tile = tile,
                       .groups = &e.contacts.groups(),
                       .laws = e.laws.data(),
                       .constants = &work.constants,
                       .slots = e.particles.loads(),
                       .sums = work.tile_sums.data(),
                       .profile = worker == 0 ? profile : nullptr});
      },
      [&](std::size_t part, unsigned worker) {
        Laps laps(worker == 0 ? profile : nullptr);
        collect(e.particles, part);
        laps.lap(Profile::reduce);
        finish_part(part, worker);
      });
  sum_loads(e.particles, e.loads);
  ContactSums sums = work.tile_sums.size() == 1 ? work.tile_sums[0] : total_of(work.tile_sums);
  work.max_overlap_ratio = sums.max_overlap_ratio = std::max(work.max_overlap_ratio, sums.max_overlap_ratio);
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
  const std::vector<kernel::Tiles::Tile>& tiles = work_->tiles.tiles();
  const std::size_t width = particles.load_width();
  const int components = features_.dimension;
  for (std::size_t plane = 0; plane < loads.size(); ++plane) {
    const auto slot = [&](const kernel::Tiles::Tile& tile) {
      return particles.loads() + (tile.first_own + plane) * width;
    };
    double* const load = loads[plane].force;
    if (tiles.size() == 1) {
      const double* const only = slot(tiles[0]);
      load[0] = only[0], load[1] = only[1], load[2] = components == 3 ? only[2] : 0;
      continue;
    }
    load[2] = 0;
    for (int k = 0; k < components; ++k)
      load[k] = exact_sum(tiles, [&](const kernel::Tiles::Tile& tile) { return slot(tile)[k]; });
  }
}

Vec3 Forces::pair_force(std::size_t p) const {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (!features_.pair_forces) return {{unknown, unknown, unknown}};
  Vec3 force = {};
  for (int k = 0; k < features_.dimension; ++k) force[k] = work_->constants.force.column(std::uint32_t(k))[p];
  return force;
}

std::size_t Forces::bytes_per_pair() const {
  return work_->constants.bytes_per_pair() + 4 * sizeof(std::uint32_t) + sizeof(std::uint8_t);
}

void Forces::transfer(const StateTransfer& state, Particles& particles, const Contacts& contacts,
                      const std::vector<LawInstance>& laws, std::size_t planes, ThreadPool& threads) {
  update_pairs(particles, contacts, reads_of(laws), planes, threads);
  state.value("max_overlap_ratio", "1", work_->max_overlap_ratio, stored::non_negative);
  if (!features_.pair_forces) return;
  PairColumns& force = work_->constants.force;
  // Counted through the pairs of all groups in scene order, each group filled up to whole lanes.
  constexpr std::uint32_t padding = ~std::uint32_t(0);
  std::vector<std::uint32_t> pairs, rows, stored;
  for (const PairGroup& group : contacts.groups()) {
    for (const std::size_t q : contacts.in_scene_order(group, particles.order()))
      pairs.push_back(std::uint32_t(q));
    pairs.resize(padded_to_lanes(pairs.size()), padding);
  }
  for (std::uint32_t row = 0; !state.restoring() && row < pairs.size(); ++row)
    if (pairs[row] != padding && force.is_used(pairs[row])) rows.push_back(row);
  state.rows("force_row", "", rows);
  for (const std::uint32_t row : rows) {
    if (row >= pairs.size() || pairs[row] == padding)
      state.refuse("force_row", "lists a pair that there is not");
    stored.push_back(pairs[row]);
  }
  force.transfer(state, "force", "N", stored);
}

bool Forces::are_in(const State& state) { return state.has("contacts/force_row"); }

}  // namespace scree
