#include "bodies/kept_rows.hpp"
#include "ranks/row_routes.hpp"

#include <algorithm>

#include <scree/particles.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

Particles::Particles(int dimension, const Features& features, std::size_t n)
    : dimension_(dimension), has_spin_(features.spin) {
  // At least one row, so that the addresses of an empty scene are valid too.
  records_.resize(std::max<std::size_t>(n, 1) * width());
  loads_.resize(std::max<std::size_t>(n, 1) * load_width());
  if (features.orientations) orientations = Orientations::room_for(dimension, n);
  if (features.images)
    for (int k = 0; k < dimension; ++k) image[k].resize(n);
  mass.resize(n);
  if (has_spin_) inertia.resize(n);
  id.resize(n);
  material.resize(n);
  if (features.fixed) fixed.resize(n);
  if (features.held) held.resize(n);
}

namespace {

Particles::Features features_with(Particles::Features features, const std::vector<Body>& bodies) {
  for (const Body& body : bodies) {
    features.fixed |= body.fixed;
    features.held |= body.held != 0;
  }
  return features;
}

}  // namespace

Particles::Particles(int dimension, const Features& features, const std::vector<Body>& bodies)
    : Particles(dimension, features_with(features, bodies), bodies.size()) {
  if (orientations) orientations = Orientations(dimension, bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    for (int k = 0; k < dimension; ++k) {
      position()[k][i] = body.position[k];
      velocity()[k][i] = mid_velocity()[k][i] = body.velocity[k];
    }
    for (int k = spin_axes().first; k < spin_axes().last; ++k) spin()[k][i] = mid_spin()[k][i] = body.spin[k];
    double* const record = records_.data() + i * width();
    record[record::position + 3] = body.radius;
    // Without an inverse, every integrator leaves the motion as it is, and pairs take the body for a wall.
    record[record::motion + 3] = body.fixed ? 0 : 1 / body.mass;
    if (has_spin_)
      record[dimension == 2 ? record::position + 2 : record::spin + 3] = body.fixed ? 0 : 1 / body.inertia;
    if (!fixed.empty()) fixed[i] = body.fixed;
    if (!held.empty()) held[i] = body.held;
    mass[i] = body.mass;
    if (has_spin_) inertia[i] = body.inertia;
    id[i] = body.id;
    material[i] = body.material;
  }
}

void Particles::transfer(const StateTransfer& state, bool mid_step) {
  const auto [first, last] = axes();
  const auto [first_spin, last_spin] = spin_axes();
  state.vectors("position", "m", position(), first, last);
  state.vectors("velocity", "m/s", velocity(), first, last);
  state.vectors("force", "N", force(), first, last);
  if (mid_step) state.vectors("mid_velocity", "m/s", mid_velocity(), first, last);
  if (has_spin_) {
    state.vectors("spin", "rad/s", spin(), first_spin, last_spin);
    state.vectors("torque", "N m", torque(), first_spin, last_spin);
    if (mid_step) state.vectors("mid_spin", "rad/s", mid_spin(), first_spin, last_spin);
  }
  if (!image[0].empty()) transfer_images(state);
  if (orientations) orientations.transfer(state, size());
}

void Particles::transfer_images(const StateTransfer& state) {
  const auto width = std::size_t(dimension_);
  std::vector<std::int32_t> all(size() * width);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = image[i % width][i / width];
  state.sized_rows("image", "1", all, width);
  for (std::size_t i = 0; i < all.size() && state.restoring(); ++i) image[i % width][i / width] = all[i];
}

template <class One, class Other, class Visit>
void Particles::each_column(One& one, Other& other, const Visit& visit) {
  visit(one.records_, other.records_, one.width());
  visit(one.loads_, other.loads_, one.load_width());
  for (int k = 0; k < 3; ++k) visit(one.image[k], other.image[k], 1);
  visit(one.mass, other.mass, 1);
  visit(one.inertia, other.inertia, 1);
  visit(one.id, other.id, 1);
  visit(one.material, other.material, 1);
  visit(one.fixed, other.fixed, 1);
  visit(one.held, other.held, 1);
}

void Particles::rearrange(const std::vector<std::uint32_t>& from, std::span<const BodyRange> kept) {
  set_load_rows(std::max<std::size_t>(size(), 1));
  each_column(*this, *this,
              [&](auto& rows, auto&, std::size_t width) { rearrange_rows(rows, width, from, kept); });
  orientations.rearrange(from, kept);
  order_ = order_.moved(from);
}

void Particles::copy_in_scene_order(Particles& copy) const {
  each_column(*this, copy, [&](const auto& by_place, auto& by_number, std::size_t width) {
    copy_rows(by_place, width, order_, by_number);
  });
  orientations.copy_in_scene_order(order_, copy.orientations);
  copy.order_ = {};
}

void Particles::copy_in_scene_order(Particles& copy, const std::vector<std::uint32_t>& numbers) const {
  each_column(*this, copy, [&](const auto& by_place, auto& by_number, std::size_t width) {
    copy_rows(by_place, width, order_, by_number, numbers);
  });
  orientations.copy_in_scene_order(order_, copy.orientations, numbers);
}

void Particles::send(Ranks& ranks, const RowRoutes& routes) {
  routes.send(ranks, records_.data(), width());
  routes.send(ranks, loads_.data(), load_width());
  for (BodyColumn<std::int32_t>& column : image)
    if (!column.empty()) routes.send(ranks, column.data(), 1);
  if (orientations) routes.send(ranks, orientations.data(), orientations.stride());
}

void Particles::send_constants(Ranks& ranks, const RowRoutes& routes) {
  each_constant([&](auto& column, std::size_t width) {
    if (!column.empty()) routes.send(ranks, column.data(), width);
  });
}

void Particles::come_to_rest(std::span<const Vec3> centres, const Domain& domain) {
  for (std::size_t i = 0; i < size(); ++i) {
    for (int k = 0; k < dimension_; ++k) {
      position()[k][i] = centres[i][k] - (image[k].empty() ? 0 : image[k][i] * domain.length(k));
      velocity()[k][i] = mid_velocity()[k][i] = 0;
    }
    for (int k = spin_axes().first; k < spin_axes().last; ++k) spin()[k][i] = mid_spin()[k][i] = 0;
  }
  std::fill(loads_.begin(), loads_.end(), 0.0);
}

Body Particles::body(std::size_t i) const {
  Body b = {.id = id[i], .material = material[i], .radius = radius()[i], .mass = mass[i]};
  if (has_spin_) b.inertia = inertia[i];
  for (int k = 0; k < dimension_; ++k) b.position[k] = position()[k][i], b.velocity[k] = velocity()[k][i];
  for (int k = spin_axes().first; k < spin_axes().last; ++k) b.spin[k] = spin()[k][i];
  b.fixed = is_fixed(i);
  if (!held.empty()) b.held = held[i];
  return b;
}

std::size_t Particles::bytes_per_body() const {
  const std::size_t doubles = width() + load_width() + (has_spin_ ? 2 : 1) + orientations.stride();
  const std::size_t images = image[0].empty() ? 0 : std::size_t(dimension_) * sizeof(std::int32_t);
  const std::size_t flags =
      (fixed.empty() ? 0u : sizeof(std::uint8_t)) + (held.empty() ? 0u : sizeof(freedom::Mask));
  return doubles * sizeof(double) + images + sizeof(std::int64_t) + sizeof(std::uint32_t) + flags;
}

}  // namespace scree
