#include "contact_kernel.hpp"

#include <scree/contact_batch.hpp>
#include <scree/forces.hpp>

namespace scree {

namespace {

using kernel::block_size;
using kernel::Buffers;
using kernel::record_width;
using kernel::Scene;

// Calls use.operator()<D, spin>() for the features of a scene.
template <class Use>
void specialise(const Forces::Features& f, const Use& use) {
  if (f.dimension == 2)
    f.spin ? use.template operator()<2, true>() : use.template operator()<2, false>();
  else
    f.spin ? use.template operator()<3, true>() : use.template operator()<3, false>();
}

int record_width_of(const Forces::Features& features) {
  int width = 0;
  specialise(features, [&]<int D, bool spin>() { width = record_width<D, spin>; });
  return width;
}

template <class T>
ContactBatch<T> batch_of(PairGroup& group, std::size_t begin, std::uint32_t padded, const Scene& s,
                         Buffers<T>& w) {
  ContactBatch<T> batch = {};
  batch.struct_size = sizeof(batch);
  batch.count = padded;
  batch.step = s.step;
  for (std::uint32_t k = 0; k < SCREE_CONTACT_INPUT_COUNT; ++k) batch.input[k] = w.input[k];
  for (std::uint32_t k = 0; k < group.history_width; ++k)
    batch.history[k] = group.history.column<T>(k) + begin;
  const std::uint32_t outputs = s.audit ? SCREE_CONTACT_OUTPUT_COUNT : SCREE_ELASTIC_NORMAL;
  for (std::uint32_t k = 0; k < outputs; ++k) batch.output[k] = w.output[k];
  return batch;
}

template <int D, bool spin, class T>
ContactSums evaluate_block(const Scene& s, const LawInstance& law, PairGroup& group, std::size_t begin,
                           std::uint32_t count, double* records, Buffers<T>& w) {
  const std::uint32_t padded = (count + SCREE_LANES - 1) / SCREE_LANES * SCREE_LANES;
  const std::size_t first = group.begin + begin;
  if (group.planes)
    for (std::uint32_t i = 0; i < count; ++i)
      kernel::gather_pair<D, spin, true, T>(s, law.interface, first + i, i, w);
  else
    for (std::uint32_t i = 0; i < count; ++i)
      kernel::gather_pair<D, spin, false, T>(s, law.interface, first + i, i, w);
  kernel::fill_padding(count, padded, w);

  const ContactBatch<T> batch = batch_of(group, begin, padded, s, w);
  if constexpr (std::is_same_v<T, float>)
    law.interface.evaluate_single(law.storage, &batch);
  else
    law.interface.evaluate(law.storage, &batch);

  kernel::scatter<D, spin, T>(law.interface, count, w, records + first * record_width<D, spin>);
  return kernel::sum_block(w, padded, s.audit);
}

// Force and torque of the bodies [begin, end): their pairs' records in ascending order.
template <int D, bool spin>
void sum_bodies(Particles& particles, const Contacts& contacts, const double* records, std::size_t begin,
                std::size_t end) {
  constexpr int S = spin_components<D>, W = record_width<D, spin>;
  for (std::size_t i = begin; i < end; ++i) {
    Vec<D> force = {};
    Vec<S> torque = {};
    for (std::uint32_t e = contacts.first_incident[i]; e < contacts.first_incident[i + 1]; ++e) {
      const std::uint32_t end_of_pair = contacts.incident[e];
      const bool is_b = end_of_pair & 1;
      const double* record = records + std::size_t(end_of_pair / 2) * W;
      const double sign = is_b ? -1 : 1;
      for (int k = 0; k < D; ++k) force[k] += sign * record[k];
      if constexpr (spin)
        for (int k = 0; k < S; ++k) torque[k] += record[D + (is_b ? S : 0) + k];
    }
    for (int k = 0; k < D; ++k) particles.force[k][i] = force[k];
    if constexpr (spin)
      for (int k = 0; k < S; ++k) particles.torque[first_spin_axis<D> + k][i] = torque[k];
  }
}

void sum_loads(const Contacts& contacts, const double* records, int dimension, int width,
               std::vector<scree_load>& loads) {
  for (scree_load& load : loads) load = {};
  for (const PairGroup& group : contacts.groups())
    if (group.planes)
      for (std::size_t p = group.begin; p < group.end; ++p)
        for (int k = 0; k < dimension; ++k)
          loads[contacts.b[p]].force[k] -= records[p * std::size_t(width) + k];
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

void Forces::plan_blocks(Contacts& contacts) {
  blocks_.clear();
  for (PairGroup& group : contacts.groups())
    for (std::size_t begin = 0; begin < group.end - group.begin; begin += block_size)
      blocks_.push_back(
          {&group, begin, std::uint32_t(std::min<std::size_t>(block_size, group.end - group.begin - begin))});
  block_sums_.resize(blocks_.size());
  records_.resize(contacts.padded_size() * std::size_t(record_width_of(features_)));
}

template <class T>
void Forces::evaluate_blocks(const Scene& scene, const std::vector<LawInstance>& laws, ThreadPool& threads) {
  specialise(features_, [&]<int D, bool spin>() {
    threads.run([&](unsigned worker) {
      Buffers<T> buffers;
      const auto part = threads.part(blocks_.size(), worker);
      for (std::size_t k = part.begin; k < part.end; ++k) {
        const Block& block = blocks_[k];
        block_sums_[k] = evaluate_block<D, spin, T>(scene, laws[block.group->law], *block.group, block.begin,
                                                    block.count, records_.data(), buffers);
      }
    });
  });
}

ContactSums Forces::evaluate(Particles& particles, Contacts& contacts, const std::vector<LawInstance>& laws,
                             const std::vector<scree_plane>& planes, std::vector<scree_load>& loads,
                             const Domain& domain, double step, ThreadPool& threads) {
  plan_blocks(contacts);
  Vec3 shifts[27];
  for (int code = 0; code < 27; ++code) shifts[code] = domain.shift(std::uint8_t(code));
  const Scene scene{particles, contacts, planes.data(), shifts, step, features_.audit};

  if (features_.precision == Precision::mixed)
    evaluate_blocks<float>(scene, laws, threads);
  else
    evaluate_blocks<double>(scene, laws, threads);
  specialise(features_, [&]<int D, bool spin>() {
    threads.run([&](unsigned worker) {
      const auto part = threads.part(particles.size(), worker);
      sum_bodies<D, spin>(particles, contacts, records_.data(), part.begin, part.end);
    });
  });
  sum_loads(contacts, records_.data(), features_.dimension, record_width_of(features_), loads);
  return add_up(block_sums_);
}

Vec3 Forces::pair_force(std::size_t p) const {
  Vec3 force = {};
  for (int k = 0; k < features_.dimension; ++k)
    force[k] = records_[p * std::size_t(record_width_of(features_)) + k];
  return force;
}

std::size_t Forces::bytes_per_pair() const {
  return std::size_t(record_width_of(features_)) * sizeof(double) + 3 * sizeof(std::uint32_t) +
         sizeof(std::uint8_t);
}

}  // namespace scree
