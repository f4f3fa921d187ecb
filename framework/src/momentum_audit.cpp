#include "instruction_levels.hpp"

#include <cmath>
#include <utility>

#include <scree/momentum_audit.hpp>

namespace scree {

namespace {

// Sum of a column and of its absolute values, in eight interleaved parts that vector registers hold.
SCREE_EVERY_LEVEL std::pair<double, double> interleaved_sums(const double* column, std::size_t count) {
  constexpr std::size_t parts = 8;
  double sum[parts] = {}, size[parts] = {};
  const std::size_t whole = count / parts * parts;
  for (std::size_t i = 0; i < whole; i += parts)
    for (std::size_t k = 0; k < parts; ++k) sum[k] += column[i + k], size[k] += std::abs(column[i + k]);
  for (std::size_t i = whole; i < count; ++i) sum[0] += column[i], size[0] += std::abs(column[i]);
  for (std::size_t k = 1; k < parts; ++k) sum[0] += sum[k], size[0] += size[k];
  return {sum[0], size[0]};
}

}  // namespace

void MomentumAudit::Sums::add(const Particles& particles, BodyRange bodies) {
  for (int k = 0; k < particles.dimension(); ++k) {
    const auto [sum, sizes] =
        interleaved_sums(particles.force[k].data() + bodies.begin, bodies.end - bodies.begin);
    force[k] += sum;
    size += sizes;
  }
}

void MomentumAudit::Sums::add(const Sums& other) {
  force += other.force;
  size += other.size;
}

void MomentumAudit::add_step(double step, Sums sums, const std::vector<scree_load>& loads) {
  for (const scree_load& load : loads)
    for (int k = 0; k < 3; ++k) sums.force[k] += load.force[k], sums.size += std::abs(load.force[k]);
  made_ += step * sums.force;
  exchanged_ += std::abs(step) * sums.size;
}

double MomentumAudit::residual() const { return exchanged_ > 0 ? norm(made_) / exchanged_ : 0; }

}  // namespace scree
