#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/probes.hpp>

namespace scree {

namespace {

void point_to(scree_column (&columns)[3], const Vectors<const double>& vectors) {
  for (int k = 0; k < 3; ++k) columns[k] = {vectors[k].data(), vectors[k].stride()};
}

}  // namespace

SimulationView::SimulationView(const Simulation& s, bool with_contacts) : energy_(s.energy()) {
  const Particles& p = s.particles();
  view_.struct_size = sizeof(view_);
  view_.dimension = std::uint32_t(s.dimension());
  view_.time = s.time();
  view_.step = s.steps();
  view_.body_count = p.size();
  point_to(view_.position, p.position());
  point_to(view_.velocity, p.velocity());
  point_to(view_.spin, p.spin());
  point_to(view_.force, p.force());
  point_to(view_.torque, p.torque());
  view_.radius = {p.radius().data(), p.radius().stride()};
  view_.mass = {p.mass.data(), 1};
  view_.id = p.id.data();
  if (with_contacts) {
    contacts_ = s.contact_list();
    view_.contact_count = contacts_.size();
    view_.contact_a = contacts_.a.data();
    view_.contact_b = contacts_.b.data();
    view_.contact_normal = contacts_.normal.data();
    view_.contact_overlap = contacts_.overlap.data();
    view_.contact_force = contacts_.force.data();
    view_.contact_sliding = contacts_.sliding.data();
  }
  for (const std::string& name : s.plane_names()) plane_names_.push_back(name.c_str());
  view_.plane_count = std::uint32_t(s.planes().size());
  view_.planes = s.planes().data();
  view_.loads = s.loads().data();
  view_.plane_names = plane_names_.data();
  view_.energy = &energy_;
}

Probe::Probe(const Parameters& parameters, int dimension)
    : plugin_(parameters, dimension, no_bounds, no_bounds), state_(plugin_.instance().state_width, 0.0) {
  for (std::uint32_t c = 0; c < plugin_.instance().column_count; ++c) {
    char name[SCREE_MAX_NAME] = "", unit[SCREE_MAX_NAME] = "";
    plugin_.interface().column(plugin_.storage(), c, name, unit);
    name[SCREE_MAX_NAME - 1] = unit[SCREE_MAX_NAME - 1] = 0;
    names_.push_back(name);
    units_.push_back(unit);
  }
}

void Probe::start(const scree_view& view, std::vector<double>& state) const {
  char message[512] = "";
  if (plugin_.interface().start(plugin_.storage(), &view, state.data(), message, sizeof(message)))
    throw Error(fmt::format("probe {}: {}", plugin_.parameters().plugin().name, message));
}

void Probe::check(const scree_view& view) const {
  std::vector<double> scratch(state_.size());
  start(view, scratch);
}

std::vector<double> Probe::sample(const scree_view& view) {
  if (!started_) start(view, state_);
  started_ = true;
  std::vector<double> row(plugin_.instance().column_count);
  plugin_.interface().sample(plugin_.storage(), &view, state_.data(), row.data());
  return row;
}

}  // namespace scree
