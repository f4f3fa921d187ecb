#include "audit/momentum_audit.hpp"

#include "machine/instruction_levels.hpp"
#include "machine/lanes.hpp"

#include <cmath>

#include <scree/state_transfer.hpp>

namespace scree {

namespace {

using kernel::Four;

// Lane-wise sums of records of four numbers and of their magnitudes, in interleaved parts so that successive
// additions do not depend on each other.
SCREE_EVERY_LEVEL void add_up(const double* first, std::size_t stride, std::size_t count, Four& sum,
                              Four& magnitude) {
  constexpr std::size_t parts = 4;
  Four sums[parts] = {}, magnitudes[parts] = {};
  const auto take = [&](std::size_t i, std::size_t part) SCREE_INLINE_LAMBDA {
    const Four numbers = kernel::load_four(first + stride * i);
    sums[part] += numbers;
    magnitudes[part] += numbers < 0 ? -numbers : numbers;
  };
  const std::size_t whole = count / parts * parts;
  for (std::size_t i = 0; i < whole; i += parts)
    for (std::size_t k = 0; k < parts; ++k) take(i + k, k);
  for (std::size_t i = whole; i < count; ++i) take(i, 0);
  sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  magnitude = (magnitudes[0] + magnitudes[1]) + (magnitudes[2] + magnitudes[3]);
}

}  // namespace

void MomentumAudit::Sums::add(const Particles& particles, BodyRange bodies) {
  Four sum, magnitudes;
  add_up(particles.loads() + bodies.begin * particles.load_width(), particles.load_width(),
         bodies.end - bodies.begin, sum, magnitudes);
  for (int k = 0; k < particles.dimension(); ++k) {
    force[k] += sum[k];
    magnitude += magnitudes[k];
  }
}

void MomentumAudit::add_step(double step, Sums sums, const std::vector<scree_load>& planes,
                             const std::vector<scree_frame_load>& surfaces) {
  const auto add = [&sums](const auto& loads) {
    for (const auto& load : loads)
      for (int k = 0; k < 3; ++k) sums.force[k] += load.force[k], sums.magnitude += std::abs(load.force[k]);
  };
  add(planes);
  add(surfaces);
  net_ += step * sums.force;
  exchanged_ += std::abs(step) * sums.magnitude;
}

double MomentumAudit::residual() const { return exchanged_ > 0 ? norm(net_) / exchanged_ : 0; }

void MomentumAudit::transfer(const StateTransfer& state) {
  state.numbers("net", "N s", net_.component, 3, stored::any);
  state.value("exchanged", "N s", exchanged_, stored::any);
}

}  // namespace scree
