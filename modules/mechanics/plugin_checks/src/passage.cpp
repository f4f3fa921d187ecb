#include "passage.hpp"

#include <cmath>
#include <numbers>

namespace scree::plugin_checks {

namespace {

constexpr double pi = std::numbers::pi;

void set_orientation(ContactColumns& contacts, std::size_t i, scree_contact_input column, int dimension,
                     double angle, const Vec3& axis) {
  if (dimension == 2) {
    contacts.input(column, 0, i) = angle;
    return;
  }
  contacts.input(column, 0, i) = std::cos(0.5 * angle);
  for (int k = 0; k < 3; ++k) contacts.input(column, 1 + k, i) = std::sin(0.5 * angle) * axis[k];
}

}  // namespace

Vec3 Frame::operator()(const Vec3& v) const {
  const double c = std::cos(angle), s = std::sin(angle);
  return c * v + s * cross(axis, v) + ((1 - c) * dot(axis, v)) * axis;
}

Passage::Passage(int dimension, const CheckedPair& pair, double contact_time)
    : dimension_(dimension),
      pair_(pair),
      contact_time_(contact_time),
      overlap_(pair.speed * contact_time / pi) {}

void Passage::set(ContactColumns& contacts, std::size_t i, int variant, int step, const Frame& frame) const {
  const bool flat = dimension_ == 2;
  const double phase = pi * (step + 0.5) / steps_touching, turned = 0.3 * variant + 0.05 * phase;
  const Vec3 normal = flat ? Vec3{{std::cos(turned), std::sin(turned), 0}}
                           : Vec3{{0.8 * std::cos(turned), 0.8 * std::sin(turned), 0.6}};
  const Vec3 first = {{-std::sin(turned), std::cos(turned), 0}},
             second = flat ? Vec3{} : cross(normal, first);
  const double sliding = speed() * (0.2 + 0.3 * (variant % 4));
  const Vec3 tangential = sliding * (std::cos(0.4 * phase) * first + 0.5 * std::sin(0.6 * phase) * second);
  const Vec3 velocity = tangential - speed() * std::cos(phase) * normal;
  const Vec3 spins = spin() * (flat ? Vec3{{0, 0, 0.3 - 0.1 * variant}} : Vec3{{0.3, -0.1 * variant, 0.2}});

  const double sign = frame.exchanged ? -1 : 1;
  const bool touching = step < steps_touching;
  const double overlap = (touching ? std::sin(phase) : -0.1) * overlap_;
  contacts.input(SCREE_OVERLAP, 0, i) = overlap;
  contacts.set(SCREE_NORMAL, sign * frame(normal), i);
  const double radius_a = pair_.radius, radius_b = 1.5 * pair_.radius;
  contacts.set(SCREE_SEPARATION, (sign * (radius_a + radius_b - overlap)) * frame(normal), i);
  contacts.input(SCREE_RADII, 0, i) = frame.exchanged ? radius_b : radius_a;
  contacts.input(SCREE_RADII, 1, i) = frame.exchanged ? radius_a : radius_b;
  contacts.set(SCREE_RELATIVE_VELOCITY, sign * frame(velocity), i);
  contacts.set(SCREE_TANGENTIAL_INCREMENT, (sign * this->step()) * frame(tangential), i);
  const Vec3 relative_spin = sign * frame(spins);
  contacts.set(SCREE_RELATIVE_SPIN, flat ? Vec3{{relative_spin[2], 0, 0}} : relative_spin, i);
  const double mass = 4.0 / 3.0 * pi * pair_.density * std::pow(pair_.radius, 3);
  contacts.input(SCREE_REDUCED_MASS, 0, i) = mass * 3.375 / (1 + 3.375);
  contacts.input(SCREE_EFFECTIVE_RADIUS, 0, i) = pair_.radius * 1.5 / 2.5;
  const Vec3 axis_a = frame(Vec3{{0.6, 0, 0.8}}), axis_b = frame(Vec3{{0, 0.8, 0.6}});
  const auto orientation_a = frame.exchanged ? SCREE_ORIENTATION_B : SCREE_ORIENTATION_A;
  const auto orientation_b = frame.exchanged ? SCREE_ORIENTATION_A : SCREE_ORIENTATION_B;
  set_orientation(contacts, i, orientation_a, dimension_, 0.01 * phase * (1 + variant), axis_a);
  set_orientation(contacts, i, orientation_b, dimension_, -0.02 * phase, axis_b);
}

}  // namespace scree::plugin_checks
