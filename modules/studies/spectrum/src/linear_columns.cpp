#include "linear_columns.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/plugin/rotation.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree::spectrum {

namespace {

using Complex = std::complex<double>;

// Largest displacement of a difference over the smallest radius: far above round-off of positions, far below
// the sizes of contacts.
constexpr double largest_share = 1e-3;

// Distance (m) from a point to the farthest surface of a body.
double farthest_body(const Simulation& simulation, const Vec3& point) {
  const Particles& p = simulation.particles();
  double farthest = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    farthest = std::max(farthest, norm(p.body(i).position - point) + p.radius()[i]);
  return farthest;
}

// All columns of one probe.
std::vector<ObservedColumn> all_of(const scenario::Plan& plan, std::size_t probe) {
  const std::vector<std::string> names = Probe(plan.probes[probe].parameters, plan.scene.dimension).names();
  std::vector<ObservedColumn> all;
  for (std::size_t c = 0; c < names.size(); ++c) {
    ObservedColumn column;
    column.probe = probe, column.column = c;
    column.name = fmt::format("{}.{}", plan.probes[probe].name, names[c]);
    all.push_back(std::move(column));
  }
  return all;
}

}  // namespace

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
  turn_walls(motion, turn, rates);
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
  frames_ = simulation_.surfaces().frames;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const Eigen::Index number = freedom_.wall(w);
    const Complex to_velocity = number == response::DegreesOfFreedom::none ? rates.exact
                                : equations_.walls[w].mass > 0             ? rates.central
                                                                           : rates.backward;
    for (int k = 0; k < 3; ++k) {
      const Complex q = turn * (number == response::DegreesOfFreedom::none
                                    ? Complex(walls_[w][k])
                                    : motion.amplitude[number] * equations_.walls[w].direction[k]);
      const bool plane = w < planes_.size();
      (plane ? planes_[w].point : frames_[w - planes_.size()].position)[k] += q.real();
      (plane ? planes_[w].velocity : frames_[w - planes_.size()].velocity)[k] += (to_velocity * q).real();
    }
  }
  view_.planes = planes_.data();
  view_.frames = frames_.data();
}

void DisplacedView::turn_walls(const response::HarmonicResponse& motion, Complex turn,
                               const response::HarmonicRates& rates) {
  for (std::size_t s = 0; s < frames_.size(); ++s) {
    const std::size_t w = planes_.size() + s;
    const Eigen::Index number = freedom_.turn(w);
    if (number == response::DegreesOfFreedom::none) continue;
    const Complex angle = turn * motion.amplitude[number];
    const double spin = (rates.central * angle).real();
    const Vec3 axis = vector_of(equations_.walls[w].axis);
    const Vec3 along = cross(axis, vector_of(frames_[s].position) - vector_of(equations_.walls[w].centre));
    const Rotation before = rotation_of(frames_[s]);
    const Rotation after = Rotation::by(angle.real() * axis) * before;
    frames_[s].orientation[0] = after.real;
    for (int k = 0; k < 3; ++k) {
      frames_[s].orientation[k + 1] = after.axis[k];
      frames_[s].position[k] += angle.real() * along[k];
      frames_[s].velocity[k] += spin * along[k];
      frames_[s].spin[k] += spin * axis[k];
    }
  }
}

LinearColumns::LinearColumns(const scenario::Plan& plan, std::vector<ObservedColumn> observed,
                             const Simulation& simulation, const std::vector<Vec3>& walls,
                             const response::DegreesOfFreedom& freedom, double time_step)
    : observer_(plan, std::move(observed)), view_(simulation, walls, freedom, time_step) {
  rest_ = observer_.values(view_.at_rest());
  for (std::size_t i = 0; i < simulation.particles().size(); ++i)
    smallest_ =
        i == 0 ? simulation.particles().radius()[i] : std::min(smallest_, simulation.particles().radius()[i]);
  radius_ = Eigen::VectorXd::Ones(freedom.size());
  for (std::size_t i = 0; i < freedom.bodies(); ++i)
    for (int k = 0; k < freedom.spins(); ++k)
      if (const Eigen::Index r = freedom.rotation(i, k); r != response::DegreesOfFreedom::none)
        radius_[r] = simulation.particles().radius()[i];
  const WallEquations equations = simulation.linear_walls();
  for (std::size_t w = 0; w < freedom.walls(); ++w)
    if (freedom.turn(w) != response::DegreesOfFreedom::none)
      radius_[freedom.turn(w)] = farthest_body(simulation, vector_of(equations.walls[w].centre));
}

std::pair<std::vector<Complex>, std::vector<double>> LinearColumns::along(
    const response::HarmonicResponse& motion) {
  // The wall moves by 1 m; rotations move surfaces by themselves times the radius.
  const double furthest = motion.amplitude.cwiseAbs().cwiseProduct(radius_).maxCoeff();
  const double share = largest_share * smallest_ / std::max(1.0, furthest);
  const std::vector<Complex> whole = difference(motion, share);
  const std::vector<Complex> half = difference(motion, 0.5 * share);
  std::vector<double> change;
  for (std::size_t c = 0; c < whole.size(); ++c) change.push_back(std::abs(whole[c] - half[c]));
  return {whole, std::move(change)};
}

std::vector<Complex> LinearColumns::difference(const response::HarmonicResponse& motion, double share) {
  using Part = DisplacedView::Part;
  std::vector<Complex> sum(rest_.size());
  for (const auto& [part, factor] : {std::pair{Part::real, Complex(1, 0)}, {Part::imaginary, Complex(0, 1)}})
    for (const double sign : {1.0, -1.0}) {
      const std::vector<double>& values = observer_.values(view_.displaced(motion, part, sign * share));
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += sign / (2 * share) * factor * values[c];
    }
  return sum;
}

bool is_of_motion(const scenario::Plan& plan, std::size_t number) {
  const Probe probe(plan.probes[number].parameters, plan.scene.dimension);
  const std::vector<scenario::ProbeInput>& inputs = plan.probes[number].inputs;
  return !probe.observes() && !(probe.needs() & (SCREE_NEEDS_CONTACTS | SCREE_NEEDS_ENERGY)) &&
         std::all_of(inputs.begin(), inputs.end(),
                     [&](const scenario::ProbeInput& input) { return is_of_motion(plan, input.probe); });
}

std::vector<std::string> responding_columns(const scenario::Plan& plan, const Simulation& simulation,
                                            const std::vector<Vec3>& walls,
                                            const response::DegreesOfFreedom& freedom,
                                            const response::HarmonicResponse& motion) {
  std::vector<std::string> names;
  for (std::size_t p = 0; p < plan.probes.size(); ++p) {
    if (!is_of_motion(plan, p)) continue;
    const std::vector<ObservedColumn> all = all_of(plan, p);
    try {
      const auto [derivatives, change] =
          LinearColumns(plan, all, simulation, walls, freedom, 0).along(motion);
      for (std::size_t c = 0; c < derivatives.size(); ++c)
        if (std::abs(derivatives[c]) > 0) names.push_back(all[c].name);
    } catch (const Error&) {
      // A probe of what the scene lacks has no columns.
    }
  }
  return names;
}

}  // namespace scree::spectrum
