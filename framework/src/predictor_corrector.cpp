#include "predictor_corrector.hpp"

#include "motion.hpp"

namespace scree {

// Higher terms start at 0; the first steps fill them.
void PredictorCorrector::prepare(const Particles& p, double step) {
  if (series_[std::size_t(p.axes().first)].second.size() == p.size()) return;
  const auto fill = [&](Series& series, const Column<double>& load, const Column<double>& inverse_inertia) {
    series.second.resize(p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
      series.second[i] = 0.5 * step * step * load[i] * inverse_inertia[i];
    series.third.assign(p.size(), 0.0);
    series.fourth.assign(p.size(), 0.0);
  };
  for (int k = p.axes().first; k < p.axes().last; ++k)
    fill(series_[std::size_t(k)], p.force[k], p.inverse_mass);
  for (int k = p.spin_axes().first; k < p.spin_axes().last; ++k)
    fill(series_[std::size_t(3 + k)], p.torque[k], p.inverse_inertia);
}

double PredictorCorrector::drift(Particles& p, double step, BodyRange bodies) {
  return move_bodies(p, bodies, p.mid_velocity, [&](const Axis& axis, std::size_t begin, std::size_t end) {
    Series& r = series_[std::size_t(axis.number)];
    double *second = r.second.data(), *third = r.third.data(), *x = axis.position;
    const double* fourth = r.fourth.data();
    const double per_step = 1 / step;
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      const double moved = step * axis.rate[i] + second[i] + third[i] + fourth[i];
      axis.mid_rate[i] = per_step * moved;
      axis.rate[i] += per_step * (2 * second[i] + 3 * third[i] + 4 * fourth[i]);
      second[i] += 3 * third[i] + 6 * fourth[i];
      third[i] += 4 * fourth[i];
    }
    move_positions(x, axis.mid_rate, step, begin, end);
  });
}

double PredictorCorrector::kick(Particles& p, double step, BodyRange bodies) {
  return move_bodies(p, bodies, p.velocity, [&](const Axis& axis, std::size_t begin, std::size_t end) {
    Series& r = series_[std::size_t(axis.number)];
    double *second = r.second.data(), *third = r.third.data(), *fourth = r.fourth.data(), *x = axis.position;
    const double half_square = 0.5 * step * step, per_step = 1 / step;
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      const double correction = half_square * axis.load[i] * axis.inverse_inertia[i] - second[i];
      axis.rate[i] += 0.75 * per_step * correction;
      second[i] += correction;
      third[i] += 0.5 * correction;
      fourth[i] += 1.0 / 12 * correction;
      if (x) x[i] += 19.0 / 90 * correction;
    }
  });
}

}  // namespace scree
