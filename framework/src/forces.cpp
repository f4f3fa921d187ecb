#include "kernel/block.hpp"
#include "kernel/evaluate.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <scree/forces.hpp>

namespace scree {

struct Forces::Work {
  explicit Work(const Features& features)
      : evaluate(kernel::tile_evaluation(features)),
        slot_width(kernel::slot_width_of(features)),
        constants(features.precision) {}

  kernel::EvaluateTile evaluate;
  std::size_t slot_width;
  std::uint64_t revision = 0;  // of the contacts that the following belongs to
  kernel::Tiles tiles;
  kernel::BodyRecords records;
  PairConstants constants;
  Column<double> slots;
  std::vector<ContactSums> block_sums;
  double deepest = 0;  // overlap ratio met so far
};

Forces::Forces(const Features& features, const Particles& particles)
    : features_(features), work_(std::make_unique<Work>(features)) {
  work_->records.resize(particles);
}
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
  for (const ContactSums& b : blocks) {
    total.elastic_normal += b.elastic_normal;
    total.elastic_tangential += b.elastic_tangential;
    total.dissipated_normal += b.dissipated_normal;
    total.dissipated_tangential += b.dissipated_tangential;
    total.dissipated_friction += b.dissipated_friction;
    total.max_overlap_ratio = std::max(total.max_overlap_ratio, b.max_overlap_ratio);
  }
  return total;
}

}  // namespace

void Forces::follow_pairs(const Particles& particles, const Contacts& contacts, std::uint32_t reads,
                          std::size_t planes) {
  Work& w = *work_;
  if (w.revision == contacts.revision()) return;
  w.revision = contacts.revision();
  w.tiles.plan(contacts, particles.size(), planes);
  w.constants.update(contacts, particles, reads, features_.pair_forces);
  w.slots.resize(w.tiles.slots() * w.slot_width);
  w.block_sums.resize(w.tiles.blocks().size());
}

void Forces::take(const Particles& particles, BodyRange bodies) { work_->records.pack(particles, bodies); }

ContactSums Forces::evaluate(const Particles& particles, Contacts& contacts,
                             const std::vector<LawInstance>& laws, const std::vector<scree_plane>& planes,
                             std::vector<scree_load>& loads, const Domain& domain, double step,
                             ThreadPool& threads) {
  Work& w = *work_;
  follow_pairs(particles, contacts, reads_of(laws), planes.size());
  alignas(32) const std::array<double, 4 * 27> shifts = image_shifts(domain);
  const kernel::Scene scene{
      particles,          contacts, w.records.data(), planes.data(),         shifts.data(),
      features_.periodic, step,     features_.audit,  features_.pair_forces, w.deepest};
  threads.each(w.tiles.tiles().size(), [&](std::size_t tile, unsigned) {
    w.evaluate({&scene, &w.tiles, tile, &contacts.groups(), laws.data(), &w.constants, w.slots.data(),
                w.block_sums.data()});
  });
  sum_loads(loads);
  ContactSums sums = add_up(w.block_sums);
  w.deepest = sums.max_overlap_ratio = std::max(w.deepest, sums.max_overlap_ratio);
  return sums;
}

void Forces::collect(std::size_t tile) {
  Work& w = *work_;
  for (const kernel::Tiles::Incoming& in : w.tiles.tiles()[tile].incoming)
    for (std::size_t k = 0; k < w.slot_width; ++k)
      w.slots[in.body * w.slot_width + k] += w.slots[in.slot * w.slot_width + k];
}

void Forces::give(Particles& p, BodyRange bodies) const {
  const Work& w = *work_;
  const auto column = [](Column<double>& c) { return c.empty() ? nullptr : c.data(); };
  double* flat[4] = {column(p.force[0]), column(p.force[1]), column(p.torque[2]), nullptr};
  double* force[4] = {column(p.force[0]), column(p.force[1]), column(p.force[2]), nullptr};
  double* torque[4] = {column(p.torque[0]), column(p.torque[1]), column(p.torque[2]), nullptr};
  kernel::deal_out(w.slots.data(), w.slot_width, features_.dimension == 2 ? flat : force, bodies);
  if (w.slot_width > 4) kernel::deal_out(w.slots.data() + 4, w.slot_width, torque, bodies);
}

void Forces::sum_loads(std::vector<scree_load>& loads) const {
  const Work& w = *work_;
  for (std::size_t plane = 0; plane < loads.size(); ++plane) {
    loads[plane] = {};
    for (std::size_t tile = 0; tile < w.tiles.tiles().size(); ++tile)
      for (int k = 0; k < features_.dimension; ++k)
        loads[plane].force[k] += w.slots[w.tiles.plane_slot(tile, plane) * w.slot_width + std::size_t(k)];
  }
}

Vec3 Forces::pair_force(std::size_t p) const {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (!features_.pair_forces) return {{unknown, unknown, unknown}};
  Vec3 force = {};
  for (int k = 0; k < features_.dimension; ++k) force[k] = work_->constants.force.value(std::uint32_t(k), p);
  return force;
}

std::size_t Forces::bytes_per_body() const {
  return work_->records.bytes_per_body() + work_->slot_width * sizeof(double);
}

std::size_t Forces::bytes_per_pair() const {
  return work_->constants.bytes_per_pair() + 4 * sizeof(std::uint32_t) + sizeof(std::uint8_t);
}

}  // namespace scree
