#include "law_under_check.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/contact_jacobian.hpp>
#include <scree/plugin/great_circle.hpp>

namespace scree::plugin_checks {

namespace {

// Rotates a body of contact 0 by an angle (rad) about axis k: about z in 2D.
void rotate(ContactColumns& contact, scree_contact_input orientation, int dimension, int k, double angle) {
  if (dimension == 2) {
    contact.input(orientation) += angle;
    return;
  }
  Vec3 rotation = {};
  rotation[k] = 2 * std::sin(0.5 * angle);
  Vec<4> quaternion;
  for (int j = 0; j < 4; ++j) quaternion[j] = contact.input(orientation, j);
  const Vec<4> change = quaternion_change(quaternion, rotation);
  for (int j = 0; j < 4; ++j)
    contact.input(orientation, j) = std::cos(0.5 * angle) * quaternion[j] + change[j];
}

// Changes contact 0 by `amount` in component k of a motion.
void change(const LawUnderCheck& law, ContactColumns& contact, PairMotion motion, int k, double amount) {
  const auto vector = [&](scree_contact_input input) {
    return Vec3{{contact.input(input, 0), contact.input(input, 1), contact.input(input, 2)}};
  };
  const Vec3 normal = vector(SCREE_NORMAL);
  Vec3 displacement = {};
  displacement[k] = amount;
  const double along = dot(displacement, normal);
  switch (motion) {
    case PairMotion::centres: {
      contact.input(SCREE_OVERLAP) -= along;
      contact.input(SCREE_SEPARATION, k) += amount;
      const Vec3 separation = law.passage.distance() * normal + displacement;
      contact.set(SCREE_NORMAL, (1 / norm(separation)) * separation);
      [[fallthrough]];  // the contact points move with the centres
    }
    case PairMotion::surfaces:
      contact.set(SCREE_TANGENTIAL_INCREMENT,
                  vector(SCREE_TANGENTIAL_INCREMENT) + displacement - along * normal);
      break;
    case PairMotion::rotation_a:
      rotate(contact, SCREE_ORIENTATION_A, law.dimension, k, amount);
      break;
    case PairMotion::rotation_b:
      rotate(contact, SCREE_ORIENTATION_B, law.dimension, k, amount);
      break;
    case PairMotion::velocity:
      contact.input(SCREE_RELATIVE_VELOCITY, k) += amount;
      break;
    case PairMotion::spin:
      contact.input(SCREE_RELATIVE_SPIN, k) += amount;
      break;
  }
}

// Output of the law at a step of the passage, with a given history.
std::vector<double> outputs_of(const LawUnderCheck& law, int variant, int step,
                               const std::vector<double>& history, PairMotion motion, int k, double amount) {
  ContactColumns contact(1);
  law.passage.set(contact, 0, variant, step);
  for (std::size_t h = 0; h < history.size(); ++h) contact.history(h) = history[h];
  change(law, contact, motion, k, amount);
  contact.evaluate(law.law, law.passage.step());
  std::vector<double> all;
  for (int row = 0; row < law.dimension; ++row) all.push_back(contact.output(SCREE_FORCE, row));
  for (int row = 0; row < law.spins(); ++row)
    all.push_back(law.has_couple() ? contact.output(SCREE_COUPLE, row) : 0);
  return all;
}

// Typical size of a motion.
double scale_of(PairMotion motion, const Passage& passage) {
  switch (motion) {
    case PairMotion::velocity:
      return passage.speed();
    case PairMotion::spin:
      return passage.spin();
    case PairMotion::rotation_a:
    case PairMotion::rotation_b:
      return passage.overlap() / passage.distance();
    default:
      return passage.overlap();
  }
}

struct Worst {
  double deviation = 0;
  int compared = 0, kinks = 0;
};

// Compares one column; where the slopes between neighbouring points differ the law changes its branch, and
// the column is left out.
void compare(const LawUnderCheck& law, int variant, int step, const std::vector<double>& history,
             PairMotion motion, int k, const ContactJacobian& derivative, const std::vector<double>& jacobian,
             Worst& worst) {
  const int rows = derivative.rows();
  const double scale = scale_of(motion, law.passage), amount = 1e-4 * scale;
  const auto at = [&](double share) {
    return outputs_of(law, variant, step, history, motion, k, share * amount);
  };
  const std::vector<double> middle = at(0), left = at(-1), right = at(1), far_left = at(-2),
                            far_right = at(2);
  double force = 1e-300, couple = 1e-300;
  for (int row = 0; row < rows; ++row) {
    double& largest = row < law.dimension ? force : couple;
    largest = std::max(largest, std::abs(middle[std::size_t(row)]) / scale);
  }
  for (int row = 0; row < rows; ++row) {
    const auto r = std::size_t(row);
    const double unit = row < law.dimension ? force : std::max(couple, force * law.passage.overlap());
    const double slopes[] = {(far_right[r] - right[r]) / amount, (right[r] - middle[r]) / amount,
                             (middle[r] - left[r]) / amount, (left[r] - far_left[r]) / amount};
    const auto [low, high] = std::minmax_element(std::begin(slopes), std::end(slopes));
    if (*high - *low > 1e-2 * (std::abs(*high) + std::abs(*low)) + 1e-3 * unit) {
      ++worst.kinks;
      continue;
    }
    const double slope = (8 * (right[r] - left[r]) - (far_right[r] - far_left[r])) / (12 * amount);
    const double exact = jacobian[std::size_t(row * derivative.columns() + derivative.first(motion) + k)];
    worst.deviation = std::max(worst.deviation, std::abs(slope - exact) / std::max(unit, std::abs(exact)));
    ++worst.compared;
  }
}

}  // namespace

// Finite differences of fourth order with steps of 1e-4: round-off 1e-12 × force/derivative, truncation
// below 1e-12 unless a branch is near.
Checks check_derivatives(const LawUnderCheck& law) {
  const std::string name = "derivatives agree with finite differences";
  if (!law.law.instance().differentiate) return {{name, Check::Verdict::skipped, "the law has none"}};
  const ContactJacobian derivative(law.law, law.dimension);
  Worst worst;
  for (int variant = 0; variant < LawUnderCheck::variants; variant += 3) {
    ContactColumns contact(1);
    std::vector<double> history(law.law.instance().history_width, 0.0);
    law.follow(contact, {}, variant, [&](int step) {
      if (step % 10 == 5 && step < Passage::steps_touching) {
        ContactColumns before(1);
        law.passage.set(before, 0, variant, step);
        for (std::size_t k = 0; k < history.size(); ++k) before.history(k) = history[k];
        std::vector<double> jacobian;
        Vec3 normal;
        for (int c = 0; c < 3; ++c) normal[c] = before.input(SCREE_NORMAL, c);
        const std::vector<PairVariation> variations(SCREE_LANES,
                                                    PairVariation::of_bodies(normal, law.passage.distance()));
        derivative.evaluate(before.batch(law.passage.step()), variations, jacobian);
        for (int m = 0; m < pair_motions; ++m)
          for (int k = 0; k < motion_components(PairMotion(m), law.dimension); ++k)
            compare(law, variant, step, history, PairMotion(m), k, derivative, jacobian, worst);
      }
      for (std::size_t k = 0; k < history.size(); ++k) history[k] = contact.history(k);
    });
  }
  Check check = bounded(name, worst.deviation, 1e-7);
  check.detail += fmt::format("; {} of {} at a change of branch", worst.kinks, worst.compared + worst.kinks);
  return {check};
}

}  // namespace scree::plugin_checks
