#include "displaced_view.hpp"

#include <numbers>

namespace scree::spectrum {

DisplacedView::DisplacedView(const Simulation& simulation, const std::vector<Vec3>& walls,
                             const response::DegreesOfFreedom& freedom, double time_step)
    : simulation_(simulation),
      walls_(walls),
      freedom_(freedom),
      rest_(simulation, 0),
      view_(rest_.get()),
      equations_(simulation.linear_walls()),
      time_step_(time_step) {
  for (int k = 0; k < simulation.dimension(); ++k) {
    position_[std::size_t(k)].resize(freedom.bodies());
    velocity_[std::size_t(k)].resize(freedom.bodies());
    view_.position[k] = {position_[std::size_t(k)].data(), 1};
    view_.velocity[k] = {velocity_[std::size_t(k)].data(), 1};
  }
}

const scree_view& DisplacedView::displaced(const response::HarmonicResponse& motion, Part part,
                                           double share) {
  const Complex turn = part == Part::real ? Complex(share, 0) : Complex(0, -share);
  const response::HarmonicRates rates(time_step_, 2 * std::numbers::pi * motion.frequency_hz);
  displace_bodies(motion, turn, rates.central);
  displace_walls(motion, turn, rates);
  return view_;
}

void DisplacedView::displace_bodies(const response::HarmonicResponse& motion, Complex turn,
                                    Complex to_velocity) {
  const Particles& p = simulation_.particles();
  const Vectors<const double> position = p.position(), velocity = p.velocity();
  for (int k = 0; k < simulation_.dimension(); ++k)
    for (std::size_t i = 0; i < freedom_.bodies(); ++i) {
      const Eigen::Index number = freedom_.translation(i, k);
      const Complex q =
          number == response::DegreesOfFreedom::none ? Complex(0) : turn * motion.amplitude[number];
      position_[std::size_t(k)][i] = position[k][i] + q.real();
      velocity_[std::size_t(k)][i] = velocity[k][i] + (to_velocity * q).real();
    }
}

void DisplacedView::displace_walls(const response::HarmonicResponse& motion, Complex turn,
                                   const response::HarmonicRates& rates) {
  planes_ = simulation_.planes();
  for (std::size_t w = 0; w < planes_.size(); ++w) {
    const Eigen::Index number = freedom_.wall(w);
    const Complex to_velocity = number == response::DegreesOfFreedom::none ? rates.exact
                                : equations_.walls[w].mass > 0             ? rates.central
                                                                           : rates.backward;
    for (int k = 0; k < 3; ++k) {
      const Complex q = turn * (number == response::DegreesOfFreedom::none
                                    ? Complex(walls_[w][k])
                                    : motion.amplitude[number] * equations_.walls[w].direction[k]);
      planes_[w].point[k] += q.real();
      planes_[w].velocity[k] += (to_velocity * q).real();
    }
  }
  view_.planes = planes_.data();
}

}  // namespace scree::spectrum
