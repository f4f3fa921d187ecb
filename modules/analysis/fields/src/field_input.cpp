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

// Where, and how fast, bodies are when body forces act on them, in the order of the simulation.
struct Evaluated {
  double time = 0;  // (s)
  std::vector<Vec3> positions, velocities;
};

Evaluated at_present(const Simulation& s, const std::vector<FieldBody>& bodies) {
  Evaluated at = {s.time(), {}, {}};
  for (const FieldBody& body : bodies) {
    at.positions.push_back(body.position);
    at.velocities.push_back(body.velocity);
  }
  return at;
}

// Columns of a batch for [[body_force]] plug-ins.
struct BatchColumns {
  std::vector<double> position[3], velocity[3], spin[3], force[3], torque[3], radius, mass, inertia;
  std::vector<std::int32_t> image[3];

  BatchColumns(const Simulation& s, const std::vector<FieldBody>& bodies, const Evaluated& at) {
    const Particles& p = s.particles();
    for (int k = 0; k < 3; ++k) {
      for (std::size_t i = 0; k < s.dimension() && i < bodies.size(); ++i) {
        position[k].push_back(at.positions[i][k]);
        velocity[k].push_back(at.velocities[i][k]);
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

void add_body_forces(const Simulation& s, const Evaluated& at, std::vector<FieldBody>& bodies) {
  if (bodies.empty()) return;
  BatchColumns columns(s, bodies, at);
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
  s.add_body_forces(batch, at.time);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (int k = 0; k < s.dimension(); ++k) bodies[i].body_force[k] = columns.force[k][i];
}

void add_group_loads(const Simulation& s, double time, std::vector<FieldBody>& bodies) {
  for (const BodyGroup& group : s.scene().groups)
    for (int k = 0; k < s.dimension(); ++k) {
      const std::vector<double>& numbers = group.load[std::size_t(k)];
      if (numbers.empty()) continue;
      const double load = Program({numbers.data(), numbers.size()})(time);
      for (const std::uint32_t i : group.bodies) bodies[i].group_load[k] += load;
    }
}

std::vector<FieldContact> contacts_of(const Simulation& s) {
  const Particles& p = s.particles();
  const ContactList list = s.loaded_contact_list();
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

FieldInput input_with(const Simulation& s, std::vector<FieldBody> bodies, const Evaluated& at) {
  FieldInput input = {.dimension = s.dimension(), .time = s.time(), .step = s.steps(), .domain = s.domain()};
  add_body_forces(s, at, bodies);
  add_group_loads(s, at.time, bodies);
  input.bodies = std::move(bodies);
  input.contacts = contacts_of(s);
  sort_by_id(input);
  return input;
}

// The body of an id in an input; null if there is none.
const FieldBody* find_body(const FieldInput& input, std::int64_t id) {
  const auto at =
      std::lower_bound(input.bodies.begin(), input.bodies.end(), id,
                       [](const FieldBody& body, std::int64_t wanted) { return body.id < wanted; });
  return at != input.bodies.end() && at->id == id ? &*at : nullptr;
}

// What a body has in the inputs of the steps before, the latest last; fewer if it is not in all.
std::vector<const FieldBody*> history_of(std::span<const FieldInput> earlier, std::int64_t id) {
  std::vector<const FieldBody*> history;
  for (const FieldInput& input : earlier)
    if (const FieldBody* body = find_body(input, id)) history.push_back(body);
  return history;
}

// A component of the position and velocity that predictor_corrector predicted for an evaluation, from those
// that it corrected with c = h²/2 F/m − (r₂ + 3r₃ + 6r₄), where r_k is h^k/k! times a derivative, and three
// forces before give r₃ and r₄: with A = h²/2 F/m, r₃ = ΔA/2 − ΔA₋/6, r₄ = ΔA/12 − ΔA₋/12.
struct Correction {
  double position, velocity;  // (m), (m/s)
};
Correction correction_of(const FieldBody& now, std::span<const FieldBody* const> last, int k, double step) {
  const auto term = [&](const FieldBody& body) { return 0.5 * step * step * body.force[k] / now.mass; };
  const double second = term(*last[2]), change = second - term(*last[1]),
               change_before = term(*last[1]) - term(*last[0]);
  const double third = change / 2 - change_before / 6, fourth = (change - change_before) / 12;
  const double c = term(now) - (second + 3 * third + 6 * fourth);
  return {19.0 / 90 * c, 0.75 * c / step};
}

// Moves one body to where, and to the velocity at which, the last evaluation took its forces.
void predict_body(Integration integration, const FieldBody& now, std::span<const FieldBody* const> history,
                  double step, int k, Vec3& position, Vec3& velocity) {
  if (now.is_held(k) || history.empty()) return;
  const FieldBody& before = *history.back();
  switch (integration) {
    case Integration::predictor_corrector: {
      if (history.size() < 3) return;
      const Correction c = correction_of(now, history.last(3), k, step);
      position[k] -= c.position;
      velocity[k] -= c.velocity;
      return;
    }
    case Integration::position_verlet:
      position[k] -= 0.5 * step * now.velocity[k];
      velocity[k] = before.velocity[k] + 0.5 * step * before.force[k] / now.mass;
      return;
    default:
      velocity[k] = before.velocity[k] + step * before.force[k] / now.mass;
  }
}

}  // namespace

bool forces_are_present(const Simulation& s) {
  if (s.scene().integration == Integration::position_verlet) return false;
  const FieldInput moving = input_of(s);
  std::vector<FieldBody> at_rest = bodies_of(s);
  for (FieldBody& b : at_rest) b.velocity = {};
  const Evaluated at = at_present(s, at_rest);
  const FieldInput resting = input_with(s, std::move(at_rest), at);
  return std::equal(moving.bodies.begin(), moving.bodies.end(), resting.bodies.begin(),
                    [](const FieldBody& a, const FieldBody& b) { return a.body_force == b.body_force; });
}

FieldInput input_of(const Simulation& s) {
  std::vector<FieldBody> bodies = bodies_of(s);
  const Evaluated at = at_present(s, bodies);
  return input_with(s, std::move(bodies), at);
}

FieldInput input_after_step(const Simulation& s, std::span<const FieldInput> earlier,
                            std::optional<double> length) {
  std::vector<FieldBody> bodies = bodies_of(s);
  Evaluated at = at_present(s, bodies);
  const Integration integration = s.scene().integration;
  const double step = length.value_or(s.step_length());
  if (integration == Integration::position_verlet) at.time -= 0.5 * step;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::vector<const FieldBody*> history = history_of(earlier, bodies[i].id);
    for (int k = 0; k < s.dimension(); ++k)
      predict_body(integration, bodies[i], history, step, k, at.positions[i], at.velocities[i]);
  }
  return input_with(s, std::move(bodies), at);
}

}  // namespace scree::fields
