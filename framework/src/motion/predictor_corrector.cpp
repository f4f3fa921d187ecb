#include "motion/predictor_corrector.hpp"

#include "bodies/kept_rows.hpp"
#include "motion/motion.hpp"
#include "ranks/row_routes.hpp"

#include <utility>

namespace scree {

using namespace kernel;

// Third and fourth derivatives start at 0; the first steps build them up.
void PredictorCorrector::prepare(Particles& particles, double step, std::span<const BodyRange> bodies) {
  const Motions motions(particles);
  const std::size_t numbers = 4 * particles.size() * motions.per_body();
  if (second_.size() == numbers) return;
  for (auto* column : {&second_, &third_, &fourth_}) *column = BodyColumn<double>(numbers);
  for (const BodyRange& range : bodies)
    motions.each(range, [&](const Motion& m) SCREE_INLINE_LAMBDA {
      store_four(second_.data() + 4 * m.number, 0.5 * step * step * m.acceleration);
    });
}

double PredictorCorrector::begin_step(Particles& particles, double step, BodyRange bodies) {
  const Motions motions(particles);
  const double per_step = 1 / step;
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    double *const at_second = second_.data() + 4 * m.number, *const at_third = third_.data() + 4 * m.number;
    const Four second = load_four(at_second), third = load_four(at_third),
               fourth = load_four(fourth_.data() + 4 * m.number);
    const Four moved = step * m.velocity + second + third + fourth;
    m.mid_velocity = per_step * moved;
    m.velocity += per_step * (2 * second + 3 * third + 4 * fourth);
    m.position += motions.axes() * moved;
    store_four(at_second, second + 3 * third + 6 * fourth);
    store_four(at_third, third + 4 * fourth);
  });
  return motions.largest_square(bodies, true);
}

bool PredictorCorrector::finish_step(Particles& particles, double step, BodyRange bodies) {
  const Motions motions(particles);
  const double half_square = 0.5 * step * step, per_step = 1 / step;
  const auto add = [](double* to, const Four& term)
                       SCREE_INLINE_LAMBDA { store_four(to, load_four(to) + term); };
  Finiteness finite;
  motions.each(bodies, [&](const Motion& m) SCREE_INLINE_LAMBDA {
    double* const second = second_.data() + 4 * m.number;
    const Four correction = half_square * m.acceleration - load_four(second);
    m.velocity += 0.75 * per_step * correction;
    add(second, correction);
    add(third_.data() + 4 * m.number, 0.5 * correction);
    add(fourth_.data() + 4 * m.number, 1.0 / 12 * correction);
    m.position += 19.0 / 90 * motions.axes() * correction;
    finite.check(m.velocity);
  });
  return finite.all_finite();
}

namespace {

// Rows of equal length, one of each body.
BodyColumn<double> in_scene_order(BodyColumn<double> derivatives, const BodyOrder& order) {
  if (order.rearranged()) rearrange_rows(derivatives, derivatives.size() / order.back().size(), order.back());
  return derivatives;
}

}  // namespace

void PredictorCorrector::add_to_hash(StateHash& hash, const BodyOrder& order) const {
  for (const auto* column : {&second_, &third_, &fourth_}) {
    const BodyColumn<double> derivatives = in_scene_order(*column, order);
    hash.add(derivatives.data(), derivatives.size());
  }
}

// Terms h²/2 x", h³/6 x‴ and h⁴/24 x⁗: lengths for translations, angles for rotations. Bodies are restored
// before they are rearranged.
void PredictorCorrector::transfer(const StateTransfer& state, const BodyOrder& order) {
  const auto transfer_column = [&](const char* name, BodyColumn<double>& column) {
    BodyColumn<double> derivatives = in_scene_order(column, order);
    state.sized_rows(name, "m or rad", derivatives, 4);
    if (state.restoring()) column = std::move(derivatives);
  };
  if (state.restoring()) {
    state.rows("second", "m or rad", second_, 4);
    third_.resize(second_.size());
    fourth_.resize(second_.size());
  }
  transfer_column("second", second_);
  transfer_column("third", third_);
  transfer_column("fourth", fourth_);
}

// A rank that has no bodies yet has no derivatives either.
void PredictorCorrector::send(Ranks& ranks, const RowRoutes& routes, std::size_t bodies) {
  std::uint64_t numbers = second_.size();
  ranks.broadcast(std::as_writable_bytes(std::span(&numbers, 1)));
  if (numbers == 0) return;
  for (auto* column : {&second_, &third_, &fourth_}) {
    column->resize(numbers);
    routes.send(ranks, column->data(), column->size() / bodies);
  }
}

void PredictorCorrector::rearrange(const std::vector<std::uint32_t>& from, std::span<const BodyRange> kept) {
  if (from.empty()) return;
  for (auto* column : {&second_, &third_, &fourth_})
    rearrange_rows(*column, column->size() / from.size(), from, kept);
}

}  // namespace scree
