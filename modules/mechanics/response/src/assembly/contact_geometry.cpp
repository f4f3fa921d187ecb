#include "assembly/contact_geometry.hpp"

#include <Eigen/Geometry>

namespace scree::response {

Block ContactGeometry::crossing(const Eigen::Vector3d& v) const {
  Block matrix(dimension, spins);
  for (int s = 0; s < spins; ++s) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(dimension == 2 ? 2 : s);
    matrix.col(s) = v.cross(axis).head(dimension);
  }
  return matrix;
}

Block ContactGeometry::turning_of_lever(double arm, const Eigen::Vector3d& force) const {
  const Eigen::VectorXd n = normal.head(dimension), f = force.head(dimension);
  Block change = -arm * crossing(force).transpose() * normal_change.topLeftCorner(dimension, dimension);
  if (arms_change) change += 0.5 * crossing(normal).transpose() * f * n.transpose();
  return change;
}

ContactGeometry::Part ContactGeometry::part(const ContactJacobian& columns, const double* jacobians,
                                            std::size_t i, PairMotion motion) const {
  using Whole = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const int rows = columns.rows(), all = columns.columns();
  const Eigen::Map<const Whole> whole(jacobians + i * std::size_t(rows * all), rows, all);
  // A scene without rotations takes no columns of these.
  const int first = columns.first(motion), count = is_turning(motion) ? spins : dimension;
  return {whole.block(0, first, dimension, count), whole.block(dimension, first, spins, count)};
}

ContactGeometry::Motion ContactGeometry::displacements(const ContactJacobian& columns,
                                                       const double* jacobians, std::size_t i) const {
  const Part by_centres = part(columns, jacobians, i, PairMotion::centres),
             by_surfaces = part(columns, jacobians, i, PairMotion::surfaces),
             by_rotation_a = part(columns, jacobians, i, PairMotion::rotation_a),
             by_rotation_b = part(columns, jacobians, i, PairMotion::rotation_b);
  const Block lever = crossing(normal);
  return {by_centres.force,    by_centres.couple,    by_surfaces.force * lever, by_surfaces.couple * lever,
          by_rotation_a.force, by_rotation_a.couple, by_rotation_b.force,       by_rotation_b.couple};
}

ContactGeometry::Motion ContactGeometry::displacements(const ContactJacobian& columns,
                                                       const double* jacobians, std::size_t i,
                                                       const SlipDerivative& slip) const {
  Motion motion = displacements(columns, jacobians, i);
  const Part by_surfaces = part(columns, jacobians, i, PairMotion::surfaces);
  const Block further = slip.by_displacement.topLeftCorner(dimension, dimension) -
                        Eigen::MatrixXd::Identity(dimension, dimension);
  motion.force_by_displacement += by_surfaces.force * further;
  motion.couple_by_displacement += by_surfaces.couple * further;
  const auto by_rotation = [&](const Eigen::Matrix3d& all) {
    return Block(all.block(0, dimension == 2 ? 2 : 0, dimension, spins));
  };
  const Block a = by_rotation(slip.by_rotation_a), b = by_rotation(slip.by_rotation_b);
  motion.force_by_turning.setZero(), motion.couple_by_turning.setZero();
  motion.force_by_rotation_a += by_surfaces.force * a, motion.couple_by_rotation_a += by_surfaces.couple * a;
  motion.force_by_rotation_b += by_surfaces.force * b, motion.couple_by_rotation_b += by_surfaces.couple * b;
  return motion;
}

ContactGeometry::Motion ContactGeometry::velocities(const ContactJacobian& columns, const double* jacobians,
                                                    std::size_t i) const {
  const Part by_velocity = part(columns, jacobians, i, PairMotion::velocity),
             by_spin = part(columns, jacobians, i, PairMotion::spin);
  const Block lever = crossing(normal);
  return {by_velocity.force,
          by_velocity.couple,
          by_velocity.force * lever,
          by_velocity.couple * lever,
          by_spin.force,
          by_spin.couple,
          -by_spin.force,
          -by_spin.couple};
}

ContactGeometry::Motion ContactGeometry::spins_of(const ContactJacobian& columns, const double* jacobians,
                                                  std::size_t i) const {
  const Part by_spin = part(columns, jacobians, i, PairMotion::spin);
  const bool of_force = !by_spin.force.isZero(0);
  const Block none_of_force = Block::Zero(dimension, spins), none_of_couple = Block::Zero(spins, spins);
  const Block of_displacement = Block::Zero(dimension, dimension);
  const Block couple_of_displacement = Block::Zero(spins, dimension);
  return {of_displacement,
          couple_of_displacement,
          none_of_force,
          none_of_couple,
          of_force ? by_spin.force : none_of_force,
          of_force ? by_spin.couple : none_of_couple,
          of_force ? Block(-by_spin.force) : none_of_force,
          of_force ? Block(-by_spin.couple) : none_of_couple};
}

Block ContactGeometry::of_bodies(const Motion& motion, const Eigen::Vector3d& force) const {
  const int D = dimension, S = spins, of_body = D + S;
  // u and w by the motions of a and b.
  Block u = Block::Zero(D, 2 * of_body), w = Block::Zero(S, 2 * of_body);
  u.leftCols(D).setIdentity();
  u.middleCols(of_body, D) = -Block::Identity(D, D);
  w.middleCols(D, S) = arm_a * Block::Identity(S, S);
  w.rightCols(S) = arm_b * Block::Identity(S, S);

  Block force_change = motion.force_by_displacement * u + motion.force_by_turning * w;
  force_change.middleCols(D, S) += motion.force_by_rotation_a;
  force_change.rightCols(S) += motion.force_by_rotation_b;
  Block couple_change = motion.couple_by_displacement * u + motion.couple_by_turning * w;
  couple_change.middleCols(D, S) += motion.couple_by_rotation_a;
  couple_change.rightCols(S) += motion.couple_by_rotation_b;
  const Block lever = crossing(normal).transpose() * force_change;
  Block result(2 * of_body, 2 * of_body);
  result.topRows(D) = -force_change;
  result.middleRows(D, S) = -(arm_a * lever + turning_of_lever(arm_a, force) * u + couple_change);
  result.middleRows(of_body, D) = force_change;
  result.bottomRows(S) = -(arm_b * lever + turning_of_lever(arm_b, force) * u - couple_change);
  return result;
}

}  // namespace scree::response
