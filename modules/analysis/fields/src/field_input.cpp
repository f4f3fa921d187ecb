#include <algorithm>
#include <numeric>

#include <scree/fields/field_input.hpp>
#include <scree/plugin/program.hpp>

namespace scree::fields {

namespace {

Vec3 vector_of_body(const Vectors<const double>& columns, std::size_t i) {
  Vec3 v = {};
  for (int k = 0; k < 3; ++k)
    if (!columns[k].empty()) v[k] = columns[k][i];
  return v;
}

freedom::Mask held_components(const Particles& p, std::size_t i) {
  freedom::Mask mask = 0;
  for (int k = 0; k < p.dimension(); ++k)
    if (p.is_held(i, k)) mask = freedom::Mask(mask | 1u << k);
  return mask;
}

// Bodies in the order of the simulation.
std::vector<FieldBody> bodies_of(const Simulation& s) {
  const Particles& p = s.particles();
  std::vector<FieldBody> bodies(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    FieldBody& b = bodies[i];
    b = {.id = p.id[i], .mass = p.mass[i], .radius = p.radius()[i]};
    b.position = vector_of_body(p.position(), i);
    b.velocity = vector_of_body(p.velocity(), i);
    b.force = vector_of_body(p.force(), i);
    b.held = held_components(p, i);
    for (std::size_t k = 0; k < 3; ++k)
      if (!p.image[k].empty()) b.image[k] = p.image[k][i];
  }
  return bodies;
}

// Columns of a batch for [[body_force]] plug-ins.
struct BatchColumns {
  std::vector<double> position[3], velocity[3], spin[3], force[3], torque[3], radius, mass, inertia;
  std::vector<std::int32_t> image[3];

  BatchColumns(const Simulation& s, const std::vector<FieldBody>& bodies,
               const std::vector<Vec3>& velocities) {
    const Particles& p = s.particles();
    for (int k = 0; k < 3; ++k) {
      for (std::size_t i = 0; k < s.dimension() && i < bodies.size(); ++i) {
        position[k].push_back(bodies[i].position[k]);
        velocity[k].push_back(velocities[i][k]);
        if (s.domain().periodic[std::size_t(k)]) image[k].push_back(bodies[i].image[std::size_t(k)]);
      }
      if (k < s.dimension()) force[k].resize(bodies.size());
      if (p.spin()[k].empty()) continue;
      for (const double component : p.spin()[k]) spin[k].push_back(component);
      torque[k].resize(bodies.size());
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      radius.push_back(bodies[i].radius);
      mass.push_back(bodies[i].mass);
      if (p.has_spin()) inertia.push_back(p.inertia[i]);
    }
  }
};

scree_column column_of(const std::vector<double>& values) {
  return {values.empty() ? nullptr : values.data(), values.empty() ? 0u : 1u};
}

void add_body_forces(const Simulation& s, const std::vector<Vec3>& velocities,
                     std::vector<FieldBody>& bodies) {
  if (bodies.empty()) return;
  BatchColumns columns(s, bodies, velocities);
  scree_body_batch batch = {};
  batch.struct_size = sizeof(batch);
  batch.dimension = std::uint32_t(s.dimension());
  batch.count = std::uint32_t(bodies.size());
  for (int k = 0; k < 3; ++k) {
    batch.position[k] = column_of(columns.position[k]);
    batch.velocity[k] = column_of(columns.velocity[k]);
    batch.spin[k] = column_of(columns.spin[k]);
    if (!columns.force[k].empty()) batch.force[k] = {columns.force[k].data(), 1};
    if (!columns.torque[k].empty()) batch.torque[k] = {columns.torque[k].data(), 1};
    if (columns.image[k].empty()) continue;
    batch.image[k] = columns.image[k].data();
    batch.period[k] = s.domain().length(k);
  }
  batch.radius = column_of(columns.radius);
  batch.mass = column_of(columns.mass);
  batch.inertia = column_of(columns.inertia);
  s.add_body_forces(batch);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (int k = 0; k < s.dimension(); ++k) bodies[i].body_force[k] = columns.force[k][i];
}

void add_group_loads(const Simulation& s, std::vector<FieldBody>& bodies) {
  for (const BodyGroup& group : s.scene().groups)
    for (int k = 0; k < s.dimension(); ++k) {
      const std::vector<double>& numbers = group.load[std::size_t(k)];
      if (numbers.empty()) continue;
      const double load = Program({numbers.data(), numbers.size()})(s.time());
      for (const std::uint32_t i : group.bodies) bodies[i].group_load[k] += load;
    }
}

std::vector<FieldContact> contacts_of(const Simulation& s) {
  const Particles& p = s.particles();
  const ContactList list = s.contact_list();
  std::vector<FieldContact> contacts(list.size());
  for (std::size_t c = 0; c < list.size(); ++c) {
    const bool wall = list.b[c] >= p.size();
    FieldContact& contact = contacts[c];
    contact.a = list.a[c];
    if (!wall) contact.b = list.b[c];
    const double distance = p.radius()[list.a[c]] + (wall ? 0 : p.radius()[list.b[c]]) - list.overlap[c];
    for (int k = 0; k < 3; ++k) {
      contact.line[k] = distance * list.normal[3 * c + std::size_t(k)];
      contact.force[k] = list.force[3 * c + std::size_t(k)];
    }
  }
  return contacts;
}

void sort_by_id(FieldInput& input) {
  std::vector<std::uint32_t> order(input.bodies.size()), rank(order.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return input.bodies[a].id < input.bodies[b].id; });
  std::vector<FieldBody> sorted;
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    rank[order[k]] = k;
    sorted.push_back(input.bodies[order[k]]);
  }
  input.bodies = std::move(sorted);
  for (FieldContact& contact : input.contacts) {
    contact.a = rank[contact.a];
    if (contact.b != FieldContact::wall) contact.b = rank[contact.b];
  }
}

// velocities: at which body forces are evaluated, of the bodies in the order of the simulation.
FieldInput input_with(const Simulation& s, std::vector<FieldBody> bodies,
                      const std::vector<Vec3>& velocities) {
  FieldInput input = {.dimension = s.dimension(), .time = s.time(), .step = s.steps(), .domain = s.domain()};
  add_body_forces(s, velocities, bodies);
  add_group_loads(s, bodies);
  input.bodies = std::move(bodies);
  input.contacts = contacts_of(s);
  sort_by_id(input);
  return input;
}

}  // namespace

bool forces_are_present(const Simulation& s) {
  if (s.scene().integration == Integration::position_verlet) return false;
  const FieldInput moving = input_of(s);
  std::vector<FieldBody> at_rest = bodies_of(s);
  for (FieldBody& b : at_rest) b.velocity = {};
  const FieldInput resting = input_with(s, std::move(at_rest), std::vector<Vec3>(s.particles().size()));
  return std::equal(moving.bodies.begin(), moving.bodies.end(), resting.bodies.begin(),
                    [](const FieldBody& a, const FieldBody& b) { return a.body_force == b.body_force; });
}

FieldInput input_of(const Simulation& s) {
  std::vector<FieldBody> bodies = bodies_of(s);
  std::vector<Vec3> velocities;
  for (const FieldBody& b : bodies) velocities.push_back(b.velocity);
  return input_with(s, std::move(bodies), velocities);
}

FieldInput input_after_step(const Simulation& s, const FieldInput& before) {
  std::vector<FieldBody> bodies = bodies_of(s);
  std::vector<Vec3> velocities;
  for (const FieldBody& b : bodies) {
    velocities.push_back(b.velocity);
    const auto earlier =
        std::lower_bound(before.bodies.begin(), before.bodies.end(), b.id,
                         [](const FieldBody& body, std::int64_t id) { return body.id < id; });
    if (earlier == before.bodies.end() || earlier->id != b.id) continue;
    for (int k = 0; k < 3; ++k)
      if (!b.is_held(k))
        velocities.back()[k] = earlier->velocity[k] + s.step_length() * earlier->force[k] / b.mass;
  }
  return input_with(s, std::move(bodies), velocities);
}

}  // namespace scree::fields
