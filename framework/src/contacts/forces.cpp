#include "contacts/forces.hpp"

#include "contacts/kernel/block.hpp"
#include "contacts/kernel/evaluate.hpp"
#include "contacts/surface_contacts.hpp"
#include "contacts/tile_schedule.hpp"
#include "ranks/rank_share.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include <scree/plugin_host.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

struct Forces::Work {
  explicit Work(const Features& features) : evaluate(kernel::tile_evaluation(features)) {}

  kernel::EvaluateTile evaluate;
  std::uint64_t revision = 0;  // of the contacts for which the members below were computed
  kernel::Tiles tiles;
  std::vector<std::uint32_t> all_tiles;
  kernel::PlaneRecords planes;
  SurfaceContacts surfaces;
  PairConstants constants;
  std::vector<ContactSums> tile_sums;
  std::optional<Halo> halo;  // if several ranks compute the scene
  ShareOrder share_order;
  TileSchedule schedule;
  double max_overlap_ratio = 0;  // largest so far
  std::optional<SlidingWork> sliding_work;
  std::vector<std::vector<SlidingWork::Slip>> slips;  // of each tile
};

Forces::Forces(const Features& features) : features_(features), work_(std::make_unique<Work>(features)) {}
Forces::~Forces() = default;

void Forces::share_with_ranks(RankShare& share) {
  share_ = &share;
  work_->halo.emplace(share);
}

bool Forces::are_of(const Contacts& contacts) const { return work_->revision == contacts.revision(); }

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
  if (work.tiles.bodies().size() != particles.size()) {
    work.tiles = kernel::Tiles(particles.size());
    work.all_tiles = TileOwners(work.tiles.bodies().count()).own();
  }
  work.tiles.plan(contacts, share_ ? share_->owners.own() : work.all_tiles, planes, threads);
  if (share_) {
    work.halo->plan(work.tiles, particles, reads & (1u << SCREE_ORIENTATION_A | 1u << SCREE_ORIENTATION_B));
    work.share_order = ShareOrder(work.tiles, share_->owners.own(), *work.halo);
  }
  work.constants.update(contacts, particles, reads, features_.pair_forces, threads);
  work.surfaces.plan(contacts, particles.width(),
                     {.slips = features_.sliding_work, .paths = (reads & (1u << SCREE_SEPARATION)) != 0});
  if (features_.sliding_work) work.slips.assign(work.tiles.tiles().size(), {});
  particles.set_load_rows(work.tiles.slots());
  work.tile_sums.assign(work.tiles.tiles().size(), {});
}

void Forces::bring_bodies_of_others(Particles& particles) {
  work_->halo->begin_records(particles);
  work_->halo->finish_records(particles);
}

void Forces::return_counts(BodyColumn<std::uint32_t>& counts) { work_->halo->return_counts(counts); }

Forces::Foreign Forces::foreign() const {
  if (!share_) return {0, 0};
  return {work_->halo->foreign_bodies(), work_->halo->bytes_sent()};
}

void Forces::clear(Particles& particles, BodyRange bodies) {
  const std::size_t width = particles.load_width();
  std::fill(particles.loads() + bodies.begin * width, particles.loads() + bodies.end * width, 0.0);
}

void Forces::evaluate(const Evaluation& e, ThreadPool& threads, const FinishPart& finish_part, RankSums& sums,
                      ContactSums& total, Profile* profile) {
  Work& work = *work_;
  Laps laps_of_search(profile);
  update_pairs(e.particles, e.contacts, reads_of(e.laws), e.planes.size() + e.surfaces.size(), threads);
  laps_of_search.lap(Profile::neighbours);
  work.planes.set(e.planes, e.particles.width());
  if (work.surfaces.any()) place_surfaces(e);
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
                                         .max_overlap_ratio = work.max_overlap_ratio,
                                         .surfaces = &work.surfaces.records(),
                                         .slips = work.surfaces.slips()};
  std::vector<std::uint8_t> springs;
  if (work.surfaces.any())
    for (const LawInstance& law : e.laws) springs.push_back(keeps_spring(law.interface, features_.dimension));
  const auto evaluate_pairs = [&](std::size_t tile, unsigned worker, kernel::TilePairs pairs) {
    if (work.surfaces.any() && pairs != kernel::TilePairs::crossing)
      work.surfaces.resolve(tile, e.contacts, e.particles, springs, work.constants);
    work.evaluate({.input = &input,
                   .tiles = &work.tiles,
                   .tile = tile,
                   .pairs = pairs,
                   .groups = &e.contacts.groups(),
                   .laws = e.laws.data(),
                   .constants = &work.constants,
                   .slots = e.particles.loads(),
                   .sums = work.tile_sums.data(),
                   .profile = worker == 0 ? profile : nullptr});
    if (work.sliding_work && work.surfaces.any() && pairs != kernel::TilePairs::crossing)
      work.slips[tile] =
          work.surfaces.slips_of(tile, e.contacts, *work.sliding_work, features_.dimension, e.elapsed < 0);
  };
  const auto finish = [&](std::size_t part, unsigned worker) {
    Laps laps(worker == 0 ? profile : nullptr);
    collect(e.particles, part);
    laps.lap(Profile::reduce);
    finish_part(part, worker);
  };
  if (share_)
    share_->busy += work.schedule.run_share(
        work.tiles, work.share_order, *work.halo, e.particles, threads,
        [&](std::size_t tile, unsigned worker, kernel::TilePairs pairs) {
          share_->failure.guard([&] { evaluate_pairs(tile, worker, pairs); });
        },
        [&](std::size_t part, unsigned worker) { share_->failure.guard([&] { finish(part, worker); }); });
  else
    work.schedule.run(
        work.tiles, threads,
        [&](std::size_t tile, unsigned worker) { evaluate_pairs(tile, worker, kernel::TilePairs::all); },
        finish);
  for (std::vector<SlidingWork::Slip>& slips : work.slips) {
    for (const SlidingWork::Slip& slip : slips) work.sliding_work->add(slip);
    slips.clear();
  }
  sum_loads(e.particles, e.loads, sums);
  sum_frame_loads(e.particles, e.loads.size(), e.frame_loads, sums);
  add_total(work.tile_sums, total, sums);
  work.max_overlap_ratio = std::max(work.max_overlap_ratio, total.max_overlap_ratio);
  total.max_overlap_ratio = work.max_overlap_ratio;
  sums.largest(total.max_overlap_ratio);
  sums.largest(work.max_overlap_ratio);
}

void Forces::collect(Particles& particles, std::size_t part) const {
  const std::size_t width = particles.load_width();
  double* const loads = particles.loads();
  for (const kernel::Tiles::Incoming& in : work_->tiles.incoming(part))
    for (std::size_t k = 0; k < width; k += 4)
      kernel::add_four(loads + in.body * width + k, kernel::load_four(loads + in.slot * width + k));
}

// Component k of what all pairs exert on a wall.
void Forces::sum_load(double& load, const Particles& particles, std::size_t wall, std::size_t k,
                      RankSums& sums) const {
  const std::vector<kernel::Tiles::Tile>& tiles = work_->tiles.tiles();
  const auto of_tile = [&](const kernel::Tiles::Tile& tile) {
    return particles.loads()[(tile.first_own + wall) * particles.load_width() + k];
  };
  if (tiles.size() == 1 && !share_) {
    load = of_tile(tiles[0]);
    return;
  }
  sums.sum(load, tiles, [&](const kernel::Tiles::Tile& tile) {
    return share_ && !share_->owners.is_own(std::size_t(&tile - tiles.data())) ? 0.0 : of_tile(tile);
  });
}

void Forces::sum_loads(const Particles& particles, std::vector<scree_load>& loads, RankSums& sums) const {
  for (std::size_t plane = 0; plane < loads.size(); ++plane) {
    loads[plane].force[2] = 0;
    for (int k = 0; k < features_.dimension; ++k)
      sum_load(loads[plane].force[k], particles, plane, std::size_t(k), sums);
  }
}

// Torques are what the loads of bodies have of them, see scree::record.
void Forces::sum_frame_loads(const Particles& particles, std::size_t planes,
                             std::vector<scree_frame_load>& loads, RankSums& sums) const {
  const bool flat = features_.dimension == 2;
  for (std::size_t s = 0; s < loads.size(); ++s) {
    loads[s] = {};
    for (int k = 0; k < features_.dimension; ++k)
      sum_load(loads[s].force[k], particles, planes + s, std::size_t(k), sums);
    for (int k = flat ? 2 : 0; k < 3; ++k)
      sum_load(loads[s].torque[k], particles, planes + s, std::size_t(flat ? k : 4 + k), sums);
  }
}

void Forces::place_surfaces(const Evaluation& e) {
  work_->surfaces.place(placed_surfaces(e.surfaces, features_.dimension, e.elapsed), e.planes.size(),
                        e.domain, e.elapsed);
}

void Forces::keep_sliding_work(const WallSurfaces& surfaces) {
  work_->sliding_work.emplace(surfaces, features_.dimension);
}

SlidingWork* Forces::sliding_work() { return work_->sliding_work ? &*work_->sliding_work : nullptr; }

PairColumns& Forces::pair_forces() { return work_->constants.force; }

std::size_t Forces::bytes_per_pair() const {
  return work_->constants.bytes_per_pair() + 4 * sizeof(std::uint32_t) + sizeof(std::uint8_t);
}

namespace {

constexpr std::uint32_t padding = ~std::uint32_t(0);

// The pairs of all groups in scene order, each group filled up to whole lanes.
std::vector<std::uint32_t> in_order_of_state(const Contacts& contacts, const BodyOrder& order) {
  std::vector<std::uint32_t> pairs;
  for (const PairGroup& group : contacts.groups()) {
    for (const std::size_t q : contacts.in_scene_order(group, order)) pairs.push_back(std::uint32_t(q));
    pairs.resize(padded_to_lanes(pairs.size()), padding);
  }
  return pairs;
}

}  // namespace

void Forces::save(const StateTransfer& state, const BodyOrder& order, const Contacts& contacts,
                  PairColumns& forces) const {
  double max_overlap_ratio = work_->max_overlap_ratio;
  state.value("max_overlap_ratio", "1", max_overlap_ratio, stored::non_negative);
  if (!features_.pair_forces) return;
  const std::vector<std::uint32_t> pairs = in_order_of_state(contacts, order);
  std::vector<std::uint32_t> rows, stored;
  for (std::uint32_t row = 0; row < pairs.size(); ++row)
    if (pairs[row] != padding && forces.is_used(pairs[row]))
      rows.push_back(row), stored.push_back(pairs[row]);
  state.rows("force_row", "", rows);
  forces.transfer(state, "force", "N", stored);
}

void Forces::restore(const StateTransfer& state, Particles& particles, const Contacts& contacts,
                     const std::vector<LawInstance>& laws, std::size_t planes, ThreadPool& threads) {
  update_pairs(particles, contacts, reads_of(laws), planes, threads);
  state.value("max_overlap_ratio", "1", work_->max_overlap_ratio, stored::non_negative);
  if (!features_.pair_forces) return;
  const std::vector<std::uint32_t> pairs = in_order_of_state(contacts, particles.order());
  std::vector<std::uint32_t> rows, stored;
  state.rows("force_row", "", rows);
  for (const std::uint32_t row : rows) {
    if (row >= pairs.size() || pairs[row] == padding)
      state.refuse("force_row", "lists a pair that there is not");
    stored.push_back(pairs[row]);
  }
  work_->constants.force.transfer(state, "force", "N", stored);
}

bool Forces::are_in(const State& state) { return state.has("contacts/force_row"); }

}  // namespace scree
