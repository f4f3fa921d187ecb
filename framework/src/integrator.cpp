#include <algorithm>
#include <limits>

#include <scree/integrator.hpp>

namespace scree {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// mid = now + h/2 a, now = now + h a.
void predict(double half_step, const double* force, const double* inverse_mass, double* now, double* mid,
             std::size_t begin, std::size_t end) {
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) {
    const double kick = half_step * force[i] * inverse_mass[i];
    mid[i] = now[i] + kick;
    now[i] = mid[i] + kick;
  }
}

// now = mid + h/2 a.
void complete(double half_step, const double* force, const double* inverse_mass, const double* mid,
              double* now, std::size_t begin, std::size_t end) {
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) now[i] = mid[i] + half_step * force[i] * inverse_mass[i];
}

double largest_square(const Column<double> (&v)[3], Particles::Axes axes, std::size_t begin,
                      std::size_t end) {
  double largest = 0;
  bool finite = true;
  for (std::size_t i = begin; i < end; ++i) {
    double square = 0;
    for (int k = axes.first; k < axes.last; ++k) square += v[k][i] * v[k][i];
    largest = std::max(largest, square);
    finite &= square < infinite;
  }
  return finite ? largest : infinite;
}

}  // namespace

double VelocityVerlet::drift(Particles& p, double step, ThreadPool& threads) {
  largest_.resize(threads.size());
  threads.run([&](unsigned worker) {
    const auto [begin, end] = threads.part(p.size(), worker);
    for (int k = p.axes().first; k < p.axes().last; ++k) {
      predict(0.5 * step, p.force[k].data(), p.inverse_mass.data(), p.velocity[k].data(),
              p.mid_velocity[k].data(), begin, end);
      double* x = p.position[k].data();
      const double* mid = p.mid_velocity[k].data();
#pragma GCC ivdep
      for (std::size_t i = begin; i < end; ++i) x[i] += step * mid[i];
    }
    for (int k = p.spin_axes().first; k < p.spin_axes().last; ++k)
      predict(0.5 * step, p.torque[k].data(), p.inverse_inertia.data(), p.spin[k].data(),
              p.mid_spin[k].data(), begin, end);
    largest_[worker] = largest_square(p.mid_velocity, p.axes(), begin, end);
  });
  return *std::max_element(largest_.begin(), largest_.end());
}

double VelocityVerlet::kick(Particles& p, double step, ThreadPool& threads) {
  largest_.resize(threads.size());
  threads.run([&](unsigned worker) {
    const auto [begin, end] = threads.part(p.size(), worker);
    for (int k = p.axes().first; k < p.axes().last; ++k)
      complete(0.5 * step, p.force[k].data(), p.inverse_mass.data(), p.mid_velocity[k].data(),
               p.velocity[k].data(), begin, end);
    for (int k = p.spin_axes().first; k < p.spin_axes().last; ++k)
      complete(0.5 * step, p.torque[k].data(), p.inverse_inertia.data(), p.mid_spin[k].data(),
               p.spin[k].data(), begin, end);
    largest_[worker] = largest_square(p.velocity, p.axes(), begin, end);
  });
  return *std::max_element(largest_.begin(), largest_.end());
}

}  // namespace scree
