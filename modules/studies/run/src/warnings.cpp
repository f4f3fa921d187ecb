#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <scree/closed_forms.hpp>
#include <scree/contact_list.hpp>
#include <scree/pictures/cut.hpp>
#include <scree/run/set_up.hpp>
#include <scree/run/step_check.hpp>
#include <scree/run/warnings.hpp>
#include <scree/surface_checks.hpp>
#include <scree/surface_outline.hpp>

namespace scree::run {

namespace {

std::string partner_name(const Simulation& s, std::uint32_t b) {
  const std::size_t bodies = s.scene().bodies.size();
  return b < bodies ? fmt::format("particle {}", s.particles().id[b])
                    : fmt::format("wall {}", s.wall_name(b - bodies));
}

void add_overlap_warning(const Simulation& s, std::vector<std::string>& warnings) {
  constexpr double much = 0.05;
  const LargestOverlap largest = largest_overlap(s);
  if (largest.ratio > much)
    warnings.push_back(fmt::format(
        "{} overlap by {:.2g} of the smaller radius at t = 0 and will be driven apart; give them a gap, or a "
        "larger periodic length",
        largest.bodies, largest.ratio));
}

ConfiguredLaw configured(const Scene& scene, std::size_t law) {
  constexpr double nowhere[3] = {};
  return ConfiguredLaw(scene.laws[law].parameters, scene.dimension, nowhere, nowhere);
}

// A closed form that is the same for all pairs.
std::optional<double> closed_form(const ConfiguredLaw& law, std::string_view name) {
  for (const scree_closed_form& form : closed_forms(law, {1, 1, 1, 1}))
    if (form.name == name) return form.value;
  return std::nullopt;
}

void add_integrator_warning(const Scene& scene, std::vector<std::string>& warnings) {
  if (scene.integration != Integration::fourth_order) return;
  for (std::size_t k = 0; k < scene.laws.size(); ++k) {
    const ConfiguredLaw law = configured(scene, k);
    if (!law.instance().tangential && closed_form(law, "restitution").value_or(1) == 1) continue;
    warnings.push_back(fmt::format(
        "time.integrator = \"fourth_order\" loses its order by friction and dashpots of {}: impacts are of second order "
        "at most, of first order with dashpots, laws for discs, rolling resistance or slip_rule = \"total\", and err "
        "up to 7 times as much as with velocity_verlet at the same step, for five times the evaluations; use "
        "\"velocity_verlet\"",
        scene.laws[k].name));
    return;
  }
}

// Of the extra normal force of springs with a potential, which has a peak in impacts that graze.
void add_grazing_warning(const Simulation& s, std::vector<std::string>& warnings) {
  const Scene& scene = s.scene();
  for (std::size_t k = 0; k < scene.laws.size(); ++k) {
    const double needed = closed_form(configured(scene, k), "grazing_steps").value_or(0);
    if (s.min_steps_per_contact() >= needed) continue;
    const scree_plugin& law = scene.laws[k].parameters.plugin();
    const bool has_history = std::any_of(
        law.parameters, law.parameters + law.parameter_count,
        [](const scree_parameter& parameter) { return std::string_view(parameter.key) == "history"; });
    warnings.push_back(fmt::format(
        "the shortest contact takes {:.3g} time steps; impacts at 80 degrees from the normal need {:.0f} with {} and "
        "the potential of its tangential spring, more as (tan of the angle)^0.8, or err by some per cent of their "
        "impulse; shorten time.step if grazing impacts matter, or use {}",
        s.min_steps_per_contact(), std::ceil(needed), scene.laws[k].name,
        has_history ? "history = \"rescaled\"" : "hertz_mindlin with history = \"rescaled\""));
    return;
  }
}

// A cut without bodies may be meant for bodies that come there.
void add_cut_warning(const scenario::SnapshotPlan& snapshot, const Simulation& s,
                     std::vector<std::string>& warnings) {
  const Particles& p = s.particles();
  if (!snapshot.image_every || p.size() == 0) return;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (pictures::reaches_into(snapshot.picture.cut, p.body(i).position.component, p.radius()[i])) return;
  warnings.push_back(fmt::format(
      "none of the {} bodies lies in snapshot.cut at the start; change it, unless bodies come there",
      p.size()));
}

// A surface has no periodic images: where it ends beyond a periodic face, bodies that re-enter do not meet
// it.
void add_periodic_warnings(const Simulation& s, std::vector<std::string>& warnings) {
  const Domain& domain = s.domain();
  if (!domain.any_periodic()) return;
  const Vec3 length = domain.upper - domain.lower;
  for (std::size_t k = 0; k < s.surfaces().size(); ++k) {
    if (s.surfaces().absent[k]) continue;
    const SurfaceOutline shape =
        outline_of(s.surfaces(), k, s.dimension(), domain.lower - length, domain.upper + length);
    for (int axis = 0; axis < s.dimension(); ++axis) {
      if (!domain.periodic[std::size_t(axis)] || shape.points.empty()) continue;
      const auto before = [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; };
      const auto [first, last] = std::minmax_element(shape.points.begin(), shape.points.end(), before);
      const double slack = 1e-9 * length[axis];
      const double low = (*first)[axis] - domain.lower[axis], high = (*last)[axis] - domain.upper[axis];
      if ((low < -slack || high > slack) && (low > slack || high < -slack))
        warnings.push_back(fmt::format(
            "surface {} crosses the periodic face {} = {:g} m, and has no image at the other one: "
            "bodies that cross the face do not meet it there; keep it inside the period, or let it "
            "go through all of it",
            s.surfaces().names[k], "xyz"[axis], low < -slack ? domain.lower[axis] : domain.upper[axis]));
    }
  }
}

}  // namespace

LargestOverlap largest_overlap(const Simulation& s) {
  const ContactList list = s.contact_list();
  const Particles& p = s.particles();
  const auto ratio = [&](std::size_t c) {
    const double radius = p.radius()[list.a[c]];
    return list.overlap[c] / (list.b[c] < p.size() ? std::min(radius, p.radius()[list.b[c]]) : radius);
  };
  std::size_t largest = 0;
  for (std::size_t c = 1; c < list.size(); ++c)
    if (ratio(c) > ratio(largest)) largest = c;
  if (list.size() == 0) return {};
  return {ratio(largest),
          fmt::format("particle {} and {}", p.id[list.a[largest]], partner_name(s, list.b[largest]))};
}

std::vector<std::string> start_warnings(const scenario::Plan& plan, const Simulation& s) {
  std::vector<std::string> warnings = plan.warnings;
  if (const auto step = step_warning(s)) warnings.push_back(*step);
  warnings.insert(warnings.end(), s.let_go().begin(), s.let_go().end());
  for (std::string& line : mesh_warnings(s.surfaces(), s.particles())) warnings.push_back(std::move(line));
  add_periodic_warnings(s, warnings);
  add_integrator_warning(s.scene(), warnings);
  add_grazing_warning(s, warnings);
  add_cut_warning(plan.snapshot, s, warnings);
  if (!plan.from_state) add_overlap_warning(s, warnings);  // a state bears its load
  return warnings;
}

std::vector<std::string> result_warnings(const Simulation& s) {
  constexpr double much = 0.05;
  std::vector<std::string> warnings;
  if (!std::isfinite(s.energy_residual()))
    warnings.push_back(
        "the energies are no longer finite numbers, so that the energy balance says nothing; look for a law, "
        "wall or body force that makes them so, or check units and magnitudes");
  if (s.energy_residual() > much)
    warnings.push_back(fmt::format(
        "the energy balance does not close, by {:.2g} of the turnover; shorten time.step, or look for a law, "
        "wall or body force that reports wrong energies",
        s.energy_residual()));
  constexpr double rounding = 1e-9;  // dissipations of 0 round to either side
  if (s.energy_created() > rounding)
    warnings.push_back(fmt::format(
        "contact laws created {:.2g} of the energy turned over (column 'created' of the probe energy): "
        "check the dissipation that a law of your own reports, and do not use history = \"displacement\" or "
        "slip_rule = \"total\", which may create some",
        s.energy_created()));
  return warnings;
}

}  // namespace scree::run
