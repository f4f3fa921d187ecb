#include "motion/driven_bodies.hpp"

#include <algorithm>
#include <tuple>

#include <scree/plugin/wall_motion.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

namespace {

// One component of the vectors of all bodies.
double& of(const Vectors<double>& translations, const Vectors<double>& rotations, int component,
           std::size_t body) {
  return component < freedom::first_rotation ? translations[component][body]
                                             : rotations[component - freedom::first_rotation][body];
}
double& velocity_of(Particles& p, int component, std::size_t body) {
  return of(p.velocity(), p.spin(), component, body);
}
double& mid_velocity_of(Particles& p, int component, std::size_t body) {
  return of(p.mid_velocity(), p.mid_spin(), component, body);
}
double& load_of(Particles& p, int component, std::size_t body) {
  return of(p.force(), p.torque(), component, body);
}
double inertia_of(const Particles& p, int component, std::size_t body) {
  return component < freedom::first_rotation ? p.mass[body] : p.inertia[body];
}

}  // namespace

double DrivenBodies::Drive::distance(double time, double step) const {
  return displacement ? program(time + step) - program(time) : step * WallMotion::mean(program, time, step);
}

double DrivenBodies::Drive::speed(double time) const {
  return displacement ? program.rate(time) : program(time);
}

void DrivenBodies::Entries::sort(std::size_t bodies) {
  // The loads of several groups on a component too, so that their sum does not depend on earlier orders.
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.body, a.component, a.function) < std::tie(b.body, b.component, b.function);
  });
  const BodyTiles tiles(bodies);
  first.assign(1, 0);
  for (std::size_t part = 0; part < tiles.parts(); ++part)
    first.push_back(std::size_t(
        std::find_if(entries.begin() + std::ptrdiff_t(first.back()), entries.end(),
                     [end = tiles.part(part).end](const Entry& entry) { return entry.body >= end; }) -
        entries.begin()));
}

void DrivenBodies::Entries::rearrange(const std::vector<std::uint32_t>& to) {
  for (Entry& entry : entries) entry.body = to[entry.body];
  sort(to.size());
}

void DrivenBodies::rearrange(const std::vector<std::uint32_t>& from) {
  if (!any()) return;
  const std::vector<std::uint32_t> to = inverse_of(from);
  held_.rearrange(to);
  loaded_.rearrange(to);
}

DrivenBodies::DrivenBodies(const Scene& scene, Particles& particles) {
  const freedom::Mask carried = particles.components();
  std::vector<freedom::Mask> driven(particles.size(), 0);
  for (const BodyGroup& group : scene.groups) add_functions(group, carried, driven);
  if (scene.bodies.empty()) {
    held_.entries.clear(), loaded_.entries.clear();
    return;
  }
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    if (!particles.is_fixed(i) && (particles.held.empty() || !particles.held[i])) continue;
    for (int k = 0; k < freedom::count; ++k) {
      if (!freedom::is_in(carried, k) || freedom::is_in(driven[i], k) || !particles.is_held(i, k)) continue;
      const double speed = velocity_of(particles, k, i);
      // A body that is fixed and at rest needs nothing: it has no inverse mass.
      if (!particles.is_fixed(i) || speed != 0)
        held_.entries.push_back({.body = i, .component = k, .speed = speed});
    }
  }
  held_.sort(particles.size());
  loaded_.sort(particles.size());
  aside_.resize(held_.entries.size());
  for (const Entry& entry : held_.entries) {
    const double speed =
        entry.function == Entry::no_function ? entry.speed : drives_[entry.function].speed(0);
    velocity_of(particles, entry.component, entry.body) = speed;
    mid_velocity_of(particles, entry.component, entry.body) = speed;
  }
}

void DrivenBodies::Entries::transfer(const StateTransfer& state, std::size_t bodies) {
  const auto column = [&](const char* name, auto Entry::*member, const StoredRange& range) {
    std::vector<std::remove_reference_t<decltype(entries[0].*member)>> numbers;
    for (const Entry& entry : entries) numbers.push_back(entry.*member);
    state.rows(name, "", numbers, 1, range);
    if (!state.restoring()) return;
    entries.resize(numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) entries[k].*member = numbers[k];
  };
  column("body", &Entry::body, stored::finite);
  column("component", &Entry::component, stored::finite);
  column("function", &Entry::function, stored::finite);
  column("speed", &Entry::speed, stored::any);
  if (state.restoring()) sort(bodies);
}

void DrivenBodies::transfer(const StateTransfer& state, std::size_t bodies) {
  held_.transfer(state.below("held"), bodies);
  loaded_.transfer(state.below("loaded"), bodies);
  aside_.resize(held_.entries.size());
}

void DrivenBodies::add_functions(const BodyGroup& group, freedom::Mask carried,
                                 std::vector<freedom::Mask>& driven) {
  const auto program_of = [](const std::vector<double>& numbers) {
    return Program({.data = numbers.data(), .count = numbers.size()});
  };
  for (int k = 0; k < freedom::count; ++k) {
    const auto c = std::size_t(k);
    if (!freedom::is_in(carried, k)) continue;
    const bool displacement = !group.displacement[c].empty();
    if (displacement || !group.velocity[c].empty()) {
      const auto function = std::uint32_t(drives_.size());
      drives_.push_back({program_of(displacement ? group.displacement[c] : group.velocity[c]), displacement});
      for (const std::uint32_t i : group.bodies) {
        held_.entries.push_back({.body = i, .component = k, .function = function});
        driven[i] |= freedom::Mask(1u << k);
      }
    }
    if (group.load[c].empty()) continue;
    const auto function = std::uint32_t(loads_.size());
    loads_.push_back(program_of(group.load[c]));
    for (const std::uint32_t i : group.bodies)
      loaded_.entries.push_back({.body = i, .component = k, .function = function});
  }
}

void DrivenBodies::plan_paces(const Times& t, Planned& planned) const {
  planned.times = t;
  planned.paces.clear();
  const bool begins = &planned == &begun_;
  const double part = t.mid_step ? 0.5 * t.step : t.step, from = begins ? t.time : t.time + t.step - part;
  for (const Drive& drive : drives_) {
    const double distance = drive.distance(t.force_time, t.elapsed), before = drive.speed(t.force_time),
                 speed = drive.speed(t.force_time + t.elapsed);
    planned.paces.push_back({.part_speed = part != 0 ? drive.distance(from, part) / part : 0,
                             .distance = distance,
                             .mean_speed = t.elapsed != 0 ? distance / t.elapsed : speed,
                             .speed = speed,
                             .end_speed = drive.speed(t.time + t.step),
                             .gain = speed * speed - before * before});
  }
}

void DrivenBodies::plan_begin(const Times& times) {
  plan_paces(times, begun_);
  begun_.loads.clear();
  for (const Program& load : loads_) begun_.loads.push_back(load(times.force_time));
}

void DrivenBodies::plan_finish(const Times& times) {
  plan_paces(times, finished_);
  finished_.loads.clear();
  for (const Program& load : loads_) finished_.loads.push_back(load(times.force_time + times.elapsed));
}

DrivenBodies::Pace DrivenBodies::pace(const Entry& entry, const Planned& planned) const {
  if (entry.function != Entry::no_function) return planned.paces[entry.function];
  const double u = entry.speed;
  return {.part_speed = u,
          .distance = u * planned.times.elapsed,
          .mean_speed = u,
          .speed = u,
          .end_speed = u,
          .gain = 0};
}

void DrivenBodies::set_aside(Particles& p, std::span<const Entry> entries) {
  const auto first = std::size_t(entries.data() - held_.entries.data());
  for (std::size_t e = 0; e < entries.size(); ++e) {
    double& load = load_of(p, entries[e].component, entries[e].body);
    aside_[first + e] = load;
    load = 0;
  }
}

void DrivenBodies::put_back(Particles& p, std::span<const Entry> entries) const {
  const auto first = std::size_t(entries.data() - held_.entries.data());
  for (std::size_t e = 0; e < entries.size(); ++e)
    load_of(p, entries[e].component, entries[e].body) = aside_[first + e];
}

void DrivenBodies::prepare(Integrator& integrator, Particles& p, double step,
                           std::span<const BodyRange> bodies) {
  set_aside(p, held_.entries);
  integrator.prepare(p, step, bodies);
  put_back(p, held_.entries);
}

double DrivenBodies::begin_step(Integrator& integrator, Particles& p, double step, BodyRange bodies,
                                std::size_t part) {
  const std::span<const Entry> held = held_.of(part);
  set_aside(p, held);
  for (const Entry& entry : held)
    velocity_of(p, entry.component, entry.body) = pace(entry, begun_).part_speed;
  const double square_speed = integrator.begin_step(p, step, bodies);
  put_back(p, held);
  return square_speed;
}

bool DrivenBodies::finish_step(Integrator& integrator, Particles& p, double step, BodyRange bodies,
                               std::size_t part) {
  const std::span<const Entry> held = held_.of(part);
  const bool mid_step = finished_.times.mid_step;
  set_aside(p, held);
  for (const Entry& entry : held)
    if (mid_step) mid_velocity_of(p, entry.component, entry.body) = pace(entry, finished_).part_speed;
  const bool finite = integrator.finish_step(p, step, bodies);
  put_back(p, held);
  for (const Entry& entry : held) {
    const Pace at = pace(entry, finished_);
    velocity_of(p, entry.component, entry.body) = at.end_speed;
    // As the integrator leaves it: the velocity at the evaluation, if that is halfway.
    if (mid_step) mid_velocity_of(p, entry.component, entry.body) = at.speed;
  }
  return finite;
}

double DrivenBodies::predict(Particles& p, std::size_t part) const {
  double work = 0;
  for (const Entry& entry : held_.of(part)) {
    const Pace at = pace(entry, begun_);
    velocity_of(p, entry.component, entry.body) = at.speed;
    mid_velocity_of(p, entry.component, entry.body) = at.mean_speed;
    work -= 0.5 * load_of(p, entry.component, entry.body) * at.distance;
  }
  for (const Entry& entry : loaded_.of(part))
    work += 0.5 * begun_.loads[entry.function] * begun_.times.elapsed *
            mid_velocity_of(p, entry.component, entry.body);
  return work;
}

void DrivenBodies::add_loads(Particles& p, std::size_t part) const {
  for (const Entry& entry : loaded_.of(part))
    load_of(p, entry.component, entry.body) += finished_.loads[entry.function];
}

double DrivenBodies::work(Particles& p, std::size_t part) const {
  double work = 0;
  for (const Entry& entry : held_.of(part)) {
    const Pace at = pace(entry, finished_);
    work += 0.5 * (inertia_of(p, entry.component, entry.body) * at.gain -
                   load_of(p, entry.component, entry.body) * at.distance);
  }
  for (const Entry& entry : loaded_.of(part))
    work += 0.5 * finished_.loads[entry.function] * finished_.times.elapsed *
            mid_velocity_of(p, entry.component, entry.body);
  return work;
}

}  // namespace scree
