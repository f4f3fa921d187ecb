#include "law_under_check.hpp"

#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include <scree/closed_forms.hpp>
#include <scree/told_apart.hpp>

namespace scree::plugin_checks {

void LawUnderCheck::follow(ContactColumns& contacts, const Frame& frame, int first,
                           const std::function<void(int)>& visit) const {
  for (int step = 0; step < Passage::steps; ++step) {
    for (std::size_t i = 0; i < contacts.size(); ++i) passage.set(contacts, i, first + int(i), step, frame);
    contacts.evaluate(law, passage.step());
    visit(step);
  }
}

std::optional<double> closed_form(const ConfiguredLaw& law, const CheckedPair& pair, int dimension,
                                  std::string_view name) {
  const double r = pair.radius, pi = std::numbers::pi;
  const double mass = pair.density * (dimension == 2 ? pi * r * r : 4.0 / 3.0 * pi * r * r * r);
  const double other = mass * (dimension == 2 ? 2.25 : 3.375);
  const scree_encounter encounter = {mass * other / (mass + other), 1.5 * r / 2.5, pair.speed, 1};
  for (const scree_closed_form& form : closed_forms(law, encounter))
    if (form.name == name) return form.value;
  return std::nullopt;
}

double contact_time_of(const ConfiguredLaw& law, const CheckedPair& pair, int dimension) {
  const double time = closed_form(law, pair, dimension, "contact_time").value_or(0);
  return std::isfinite(time) ? time : 0;
}

Check bounded(const std::string& name, double measured, double bound) {
  // False for NaN.
  const bool holds = measured <= bound;
  const auto [shown, most] = told_apart(measured, bound, 2);
  return {name, holds ? Check::Verdict::passed : Check::Verdict::failed,
          fmt::format("{}, at most {}", shown, most)};
}

}  // namespace scree::plugin_checks
