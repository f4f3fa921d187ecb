#include "trajectory.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include <scree/state_file/trajectory.hpp>

namespace scree::run {

namespace {

using Order = std::vector<std::size_t>;

// The order in memory is arbitrary.
Order by_id(const Particles& p) {
  Order order(p.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return p.id[i] < p.id[j]; });
  return order;
}

template <class T>
StateArray column(const Order& order, const char* unit, const auto& value_of) {
  std::vector<T> values;
  for (const std::size_t i : order) values.push_back(T(value_of(i)));
  return {values, {order.size()}, unit};
}

// Components first to last - 1; a vector of one component is a number for each body.
template <class T>
StateArray columns(const Order& order, const char* unit, int first, int last, const auto& value_of) {
  std::vector<T> values;
  for (const std::size_t i : order)
    for (int k = first; k < last; ++k) values.push_back(value_of(k, i));
  std::vector<std::size_t> shape = {order.size()};
  if (last - first > 1) shape.push_back(std::size_t(last - first));
  return {values, shape, unit};
}

void add_moving(const Particles& p, const Order& order, const Domain& domain,
                state_file::TrajectoryFrame& frame) {
  const int d = p.dimension();
  const auto of = [](const auto& vectors) {
    return [vectors](int k, std::size_t i) { return vectors[k][i]; };
  };
  frame.moving["position"] = columns<double>(order, "m", 0, d, of(p.position()));
  frame.moving["velocity"] = columns<double>(order, "m/s", 0, d, of(p.velocity()));
  if (p.has_spin())
    frame.moving["spin"] =
        columns<double>(order, "rad/s", p.spin_axes().first, p.spin_axes().last, of(p.spin()));
  if (domain.any_periodic())
    frame.moving["image"] = columns<std::int32_t>(order, "", 0, d, [&](int k, std::size_t i) {
      return domain.periodic[std::size_t(k)] ? p.image[k][i] : 0;
    });
}

state_file::TrajectoryFrame frame_of(const Simulation& s) {
  const Particles& p = s.particles();
  const Order order = by_id(p);
  state_file::TrajectoryFrame frame;
  frame.time = s.time();
  frame.step = s.steps();
  frame.dimension = s.dimension();
  frame.periodic = s.domain().periodic;
  for (int k = 0; k < s.dimension(); ++k)
    if (frame.periodic[std::size_t(k)]) frame.edges[std::size_t(k)] = s.domain().length(k);
  frame.fixed["id"] = column<std::int64_t>(order, "", [&](std::size_t i) { return p.id[i]; });
  frame.fixed["species"] = column<std::uint32_t>(order, "", [&](std::size_t i) { return p.material[i]; });
  frame.fixed["mass"] = column<double>(order, "kg", [&](std::size_t i) { return p.mass[i]; });
  frame.fixed["radius"] = column<double>(order, "m", [&](std::size_t i) { return p.radius()[i]; });
  add_moving(p, order, s.domain(), frame);
  return frame;
}

}  // namespace

void Trajectory::add(const Simulation& simulation) {
  state_file::append_frame(directory_.add(file_name), frame_of(simulation), frames_);
  ++frames_;
}

void Trajectory::transfer(const StateTransfer& state) {
  state.value("frames", "1", frames_);
  if (state.restoring() && frames_ > 0) state_file::check_frames(directory_.path() / file_name, frames_);
}

void Trajectory::cut() {
  if (frames_ > 0) state_file::cut_frames(directory_.path() / file_name, frames_);
}

}  // namespace scree::run
