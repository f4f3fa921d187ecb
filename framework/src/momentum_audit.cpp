#include <cmath>
#include <utility>

#include <scree/momentum_audit.hpp>

namespace scree {

namespace {

// Sum of a column and of its absolute values, in eight interleaved parts that vector registers hold.
std::pair<double, double> interleaved_sums(const Column<double>& column) {
  constexpr std::size_t parts = 8;
  double sum[parts] = {}, size[parts] = {};
  const std::size_t whole = column.size() / parts * parts;
  for (std::size_t i = 0; i < whole; i += parts)
    for (std::size_t k = 0; k < parts; ++k) sum[k] += column[i + k], size[k] += std::abs(column[i + k]);
  for (std::size_t i = whole; i < column.size(); ++i) sum[0] += column[i], size[0] += std::abs(column[i]);
  for (std::size_t k = 1; k < parts; ++k) sum[0] += sum[k], size[0] += size[k];
  return {sum[0], size[0]};
}

}  // namespace

void MomentumAudit::add_step(double step, const Particles& particles, const std::vector<scree_load>& loads) {
  for (int k = 0; k < particles.dimension(); ++k) {
    auto [sum, size] = interleaved_sums(particles.force[k]);
    for (const scree_load& load : loads) sum += load.force[k], size += std::abs(load.force[k]);
    made_[k] += step * sum;
    exchanged_ += std::abs(step) * size;
  }
}

double MomentumAudit::residual() const { return exchanged_ > 0 ? norm(made_) / exchanged_ : 0; }

}  // namespace scree
