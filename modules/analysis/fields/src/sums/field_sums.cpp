#include <algorithm>
#include <cmath>

#include <scree/error.hpp>
#include <scree/fields/field_sums.hpp>
#include <scree/plugin/sphere_volumes.hpp>

namespace scree::fields {

namespace {

double largest_component(const Vec3& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

void add_product(double factor, const Vec3& u, const Vec3& v, Tensor& tensor) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) tensor[std::size_t(3 * i + j)] += factor * u[i] * v[j];
}

// The force that would hold the body, if it is not accelerated.
Vec3 holding_force(const FieldBody& body) {
  Vec3 force = {};
  for (int k = 0; k < 3; ++k)
    if (body.is_held(k)) force[k] = -body.force[k];
  return force;
}

// Adds a mass per volume with a velocity; the mean and the spread about it are updated together (West,
// Commun. ACM 22, 532 (1979)), so that a fast drift costs the spread no digits.
void add_motion(double mass, const Vec3& velocity, FieldPoint& point) {
  const double before = point.density;
  point.density += mass;
  const Vec3 off = velocity - point.velocity;
  add_product(mass * (before / point.density), off, off, point.kinetic_stress);
  point.velocity += (mass / point.density) * off;
}

constexpr std::size_t slabs_per_thread = 4;

}  // namespace

void check_input(const FieldGrid& grid, const FieldInput& input) {
  if (input.dimension != grid.dimension)
    throw Error("", "the states have scenes in 2D and in 3D", "give states of one run");
  for (int k = 0; k < grid.dimension; ++k)
    if ((input.domain.periodic[std::size_t(k)] ? input.domain.length(k) : 0) != grid.period[k])
      throw Error("", "the states have different periodic lengths", "give states of one run");
}

FieldSums::FieldSums(const FieldGrid& grid, const AveragingKernel& kernel)
    : grid_(grid), kernel_(kernel), points_(grid.size()) {}

void FieldSums::add(const FieldInput& input, ThreadPool& threads) {
  check_input(grid_, input);
  // A point is in one slab, and has its terms in the order of bodies and contacts whatever the slabs are.
  const std::size_t slabs = threads.size() == 1 ? 1 : slabs_per_thread * threads.size();
  threads.each(slabs, [&](std::size_t part, unsigned) {
    const GridSlab slab = grid_.slab(part, slabs);
    if (slab.begin == slab.end) return;
    for (const FieldBody& body : input.bodies) add_body(body, slab);
    for (const FieldContact& contact : input.contacts) add_contact(input, contact, slab);
  });
  ++inputs_;
  time_ += input.time;
}

void FieldSums::add_body(const FieldBody& body, const GridSlab& slab) {
  const double volume = volume_of_sphere(grid_.dimension, body.radius);
  const Vec3 held = holding_force(body);
  const double largest = std::max({largest_component(body.force), largest_component(body.body_force),
                                   largest_component(body.group_load)});
  grid_.each_near(body.position, {}, kernel_.width(), slab, [&](std::size_t number, const Vec3& offset) {
    const double weight = kernel_(dot(offset, offset));
    if (!(weight > 0)) return;
    FieldPoint& point = points_[number];
    add_motion(body.mass * weight, body.velocity, point);
    point.solid_fraction += volume * weight;
    point.momentum += body.mass * weight * body.velocity;
    point.net_force += weight * body.force;
    point.body_force += weight * body.body_force;
    point.group_load += weight * body.group_load;
    point.holding_force += weight * held;
    point.largest_term = std::max(point.largest_term, weight * largest);
  });
}

void FieldSums::add_contact(const FieldInput& input, const FieldContact& contact, const GridSlab& slab) {
  const Vec3 start = input.bodies[contact.a].position - contact.line;
  const double largest = largest_component(contact.force);
  const bool wall = contact.b == FieldContact::wall;
  grid_.each_near(start, contact.line, kernel_.width(), slab, [&](std::size_t number, const Vec3& offset) {
    const AlongLine along = kernel_.along(offset, contact.line);
    if (!(along.weight > 0)) return;
    FieldPoint& point = points_[number];
    add_product(along.weight, contact.force, contact.line, point.contact_stress);
    point.stress_divergence += along.drop * contact.force;
    double term = std::abs(along.drop);
    if (wall) {
      const double weight = kernel_(dot(offset, offset));
      point.traction += weight * contact.force;
      term = std::max(term, weight);
    }
    point.largest_term = std::max(point.largest_term, term * largest);
  });
}

std::vector<FieldPoint> FieldSums::means() const {
  std::vector<FieldPoint> means = points_;
  const double share = inputs_ ? 1 / double(inputs_) : 0;
  for (FieldPoint& point : means) {
    point.density *= share;
    point.solid_fraction *= share;
    for (Vec3* v : {&point.momentum, &point.stress_divergence, &point.traction, &point.body_force,
                    &point.group_load, &point.holding_force, &point.net_force})
      *v = share * *v;
    for (double& component : point.kinetic_stress) component *= share;
    for (double& component : point.contact_stress) component *= share;
  }
  return means;
}

double force_residual(const std::vector<FieldPoint>& points) {
  double residual = 0, term = 0;
  for (const FieldPoint& point : points) {
    residual = std::max(residual, largest_component(point.residual()));
    term = std::max(term, point.largest_term);
  }
  return term > 0 ? residual / term : 0;
}

}  // namespace scree::fields
