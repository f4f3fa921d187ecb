#include "mode_properties.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::modes {

namespace {

constexpr double least_share = 0.01;
constexpr std::size_t most_participants = 5;

using response::DegreesOfFreedom;

// Kinetic energies of the bodies in a mode of qᵀ M q = 1, whose sum with that of walls is 1.
struct Energies {
  std::vector<double> of_body;
  std::array<double, 3> translation = {};
  double rotation = 0, walls = 0, turns = 0;
  std::size_t held = 0;
};

Energies energies_of(const Eigen::VectorXd& q, const response::LinearSystem& system) {
  const DegreesOfFreedom& freedom = system.freedom;
  Energies e = {.of_body = std::vector<double>(freedom.bodies(), 0.0)};
  const auto energy = [&](Eigen::Index k) {
    return k == DegreesOfFreedom::none ? 0 : system.mass[k] * q[k] * q[k];
  };
  for (std::size_t i = 0; i < freedom.bodies(); ++i) {
    e.held += freedom.moves(i);
    for (int k = 0; k < freedom.dimension(); ++k) {
      const double part = energy(freedom.translation(i, k));
      e.translation[std::size_t(k)] += part, e.of_body[i] += part;
    }
    for (int k = 0; k < freedom.spins(); ++k) {
      const double part = energy(freedom.rotation(i, k));
      e.rotation += part, e.of_body[i] += part;
    }
  }
  for (std::size_t w = 0; w < freedom.walls(); ++w)
    e.walls += energy(freedom.wall(w)), e.turns += energy(freedom.turn(w));
  return e;
}

double participation_of(const Energies& e) {
  double sum = 0, squares = 0;
  for (const double one : e.of_body) sum += one, squares += one * one;
  return squares > 0 ? sum * sum / (double(e.held) * squares) : 0;
}

std::vector<Participant> participants_of(const std::vector<double>& energies, double least) {
  std::vector<Participant> all;
  for (std::uint32_t i = 0; i < energies.size(); ++i)
    if (energies[i] >= least) all.push_back({i, energies[i]});
  std::stable_sort(all.begin(), all.end(),
                   [](const Participant& a, const Participant& b) { return a.share > b.share; });
  return all;
}

}  // namespace

std::vector<Mode> properties_of(const response::FoundModes& found, const response::LinearSystem& system) {
  std::vector<Mode> modes;
  for (std::size_t m = 0; m < std::size_t(found.square_frequency.size()); ++m) {
    const Eigen::VectorXd q = found.shape.col(Eigen::Index(m));
    const Energies e = energies_of(q, system);
    const std::size_t first[] = {0, found.first_floppy, found.first_vibrating};
    const std::size_t kind = m >= first[2] ? 2 : m >= first[1] ? 1 : 0;
    const double square = found.square_frequency[Eigen::Index(m)];
    std::vector<Participant> participants = participants_of(e.of_body, least_share);
    if (participants.size() > most_participants) participants.resize(most_participants);
    modes.push_back({.kind = ModeKind(kind),
                     .number = int(m - first[kind]) + 1,
                     .square_frequency = square,
                     .frequency_hz = kind == 2 ? std::sqrt(square) / (2 * std::numbers::pi) : 0,
                     .residual = found.residual[Eigen::Index(m)],
                     .participation = participation_of(e),
                     .rotation = e.rotation,
                     .direction = e.translation,
                     .walls = e.walls,
                     .turns = e.turns,
                     .damping_rate = q.dot(system.damping * q),
                     .participants = participants});
  }
  return modes;
}

std::vector<Participant> floppy_bodies(const response::FoundModes& found,
                                       const response::LinearSystem& system) {
  std::vector<double> sum(system.freedom.bodies(), 0.0);
  for (std::size_t m = found.first_floppy; m < found.first_vibrating; ++m) {
    const Energies e = energies_of(found.shape.col(Eigen::Index(m)), system);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += e.of_body[i];
  }
  return participants_of(sum, least_share);
}

}  // namespace scree::modes
