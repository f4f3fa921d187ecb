#include "bodies/kept_rows.hpp"

#include <cmath>

#include <scree/body_order.hpp>
#include <scree/orientations.hpp>
#include <scree/plugin/rotation.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

namespace {

using Quaternion = Vec<4>;  // (w, x, y, z)

// (exp(r/2) − 1) q: the change of q by the rotation r.
Quaternion change_of(const Quaternion& q, const HalfAngle& r) {
  const Vec3 axis = {{q[1], q[2], q[3]}};
  const Vec3 turned = q[0] * r.sine + cross(r.sine, axis);
  const double c = r.cosine_minus_one;
  return {{c * q[0] - dot(r.sine, axis), c * axis[0] + turned[0], c * axis[1] + turned[1],
           c * axis[2] + turned[2]}};
}

// Adds a change to a sum and its rounded-off part (D. E. Knuth, TAOCP 2, section 4.2.2, theorem B).
void add(double& sum, double& rounded_off, double change) {
  const double term = change + rounded_off, total = sum + term;
  const double share = total - sum;
  rounded_off = (sum - (total - share)) + (term - share);
  sum = total;
}

void rotate_quaternion(double* body, const Vec3& rotation) {
  const Quaternion q = {{body[0], body[1], body[2], body[3]}};
  const double excess = dot(q, q) - 1;
  const Quaternion change = change_of(q, half_angle_of(rotation));
  for (int k = 0; k < 4; ++k) add(body[k], body[4 + k], change[k] - 0.5 * excess * q[k]);
}

}  // namespace

Orientations::Orientations(int dimension, std::size_t bodies) {
  *this = room_for(dimension, bodies);
  if (components_ == orientation_components<3>)
    for (std::size_t i = 0; i < size_; ++i) values_[i * stride()] = 1;
}

Orientations Orientations::room_for(int dimension, std::size_t bodies) {
  Orientations room;
  room.components_ = dimension == 2 ? orientation_components<2> : orientation_components<3>;
  room.size_ = bodies;
  room.values_.resize(bodies * room.stride());
  return room;
}

void Orientations::rotate(const Vectors<const double>& spin, double time, std::size_t begin,
                          std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    double* const body = values_.data() + i * stride();
    if (components_ == orientation_components<2>)
      add(body[0], body[1], time * spin[2][i]);
    else
      rotate_quaternion(body, time * Vec3{{spin[0][i], spin[1][i], spin[2][i]}});
  }
}

void Orientations::transfer(const StateTransfer& state, std::size_t bodies) {
  const Vectors<double> sums(values_.data(), stride(), bodies, 0, components_);
  const Vectors<double> rounded_off(values_.data() + components_, stride(), bodies, 0, components_);
  const char* const unit = components_ == orientation_components<2> ? "rad" : "1";
  state.vectors("orientation", unit, sums, 0, components_);
  state.vectors("orientation_rounded_off", unit, rounded_off, 0, components_);
  if (!state.restoring() || components_ == orientation_components<2>) return;
  for (std::size_t i = 0; i < bodies; ++i) {
    const double* const q = values_.data() + i * stride();
    constexpr double tolerance = 1e-6;  // far above the round-off of rotations
    if (!(std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1) <= tolerance))
      state.refuse("orientation", "has a quaternion whose length is not 1");
  }
}

void Orientations::rearrange(const std::vector<std::uint32_t>& from, std::span<const BodyRange> kept) {
  rearrange_rows(values_, stride(), from, kept);
}

void Orientations::copy_in_scene_order(const BodyOrder& order, Orientations& copy) const {
  copy_rows(values_, stride(), order, copy.values_);
}

void Orientations::copy_in_scene_order(const BodyOrder& order, Orientations& copy,
                                       const std::vector<std::uint32_t>& numbers) const {
  copy_rows(values_, stride(), order, copy.values_, numbers);
}

bool Orientations::are_in(const StateTransfer& state) { return state.has("orientation"); }

}  // namespace scree
