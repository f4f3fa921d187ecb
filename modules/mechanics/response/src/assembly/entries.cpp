#include "assembly/entries.hpp"

namespace scree::response {

void Entries::add(const std::vector<std::uint32_t>& ends, const Block& block) {
  const int of_body = freedom_.dimension() + freedom_.spins();
  for (Eigen::Index r = 0; r < block.rows(); ++r) {
    const Share row = share(ends[std::size_t(r / of_body)], int(r % of_body));
    if (row.weight == 0) continue;
    for (Eigen::Index c = 0; c < block.cols(); ++c) {
      const std::uint32_t end = ends[std::size_t(c / of_body)];
      const int k = int(c % of_body);
      const double value = row.weight * block(r, c);
      if (const Share of = share(end, k); of.weight != 0)
        motions_.emplace_back(row.number, of.number, of.weight * value);
      if (end >= freedom_.bodies() && k < freedom_.dimension())
        add_to_wall(row.number, end - freedom_.bodies(), k, value);
    }
  }
}

void Entries::add_turn(std::uint32_t body, std::size_t wall, const TurnTerms& terms) {
  const Eigen::Index turn = freedom_.turn(wall);
  for (Eigen::Index k = 0; k < terms.by_turn.size(); ++k) {
    const Share own = share(body, int(k));
    if (own.weight == 0) continue;
    motions_.emplace_back(own.number, turn, terms.by_turn[k]);
    motions_.emplace_back(turn, own.number, terms.of_torque[k]);
  }
  for (int k = 0; k < freedom_.dimension(); ++k) {
    const Share along = share(std::uint32_t(freedom_.bodies() + wall), k);
    if (along.weight != 0) {
      motions_.emplace_back(along.number, turn, -along.weight * terms.by_turn[k]);
      motions_.emplace_back(turn, along.number, -along.weight * terms.of_torque[k]);
    }
    add_to_wall(turn, wall, k, -terms.of_torque[k]);
  }
  add_own_turn(wall, terms.own);
}

Entries::Share Entries::share(std::uint32_t end, int k) const {
  const bool translation = k < freedom_.dimension();
  if (end >= freedom_.bodies()) {
    const std::size_t wall = end - freedom_.bodies();
    if (!translation || freedom_.wall(wall) == DegreesOfFreedom::none) return {DegreesOfFreedom::none, 0};
    return {freedom_.wall(wall), equations_.walls[wall].direction[k]};
  }
  const Eigen::Index number =
      translation ? freedom_.translation(end, k) : freedom_.rotation(end, k - freedom_.dimension());
  return {number, number == DegreesOfFreedom::none ? 0.0 : 1.0};
}

void Entries::add_to_wall(Eigen::Index row, std::size_t wall, int k, double value) {
  walls_.emplace_back(row, column(wall, k), value);
  if (freedom_.wall(wall) != DegreesOfFreedom::none)
    add_to_wall_along(row, wall, -equations_.walls[wall].direction[k] * value);
}

void Entries::add_to_wall_along(Eigen::Index row, std::size_t wall, double value) {
  for (int k = 0; k < freedom_.dimension(); ++k)
    walls_.emplace_back(row, column(wall, k), equations_.walls[wall].direction[k] * value);
}

void Entries::add_along(std::size_t w, std::size_t moved, double value) {
  if (freedom_.wall(moved) != DegreesOfFreedom::none)
    motions_.emplace_back(freedom_.wall(w), freedom_.wall(moved), value);
  else
    add_to_wall_along(freedom_.wall(w), moved, value);
}

void Entries::add_inertial(std::size_t w, double value) {
  motions_.emplace_back(freedom_.wall(w), freedom_.wall(w), value);
  add_to_wall_along(freedom_.wall(w), w, -value);
}

Eigen::SparseMatrix<double> Entries::matrix(const std::vector<Triplet>& entries, Eigen::Index columns) const {
  Eigen::SparseMatrix<double> sum(freedom_.size(), columns);
  sum.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

}  // namespace scree::response
