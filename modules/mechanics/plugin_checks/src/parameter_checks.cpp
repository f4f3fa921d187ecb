#include "law_under_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::plugin_checks {

namespace {

using Verdict = Check::Verdict;

// Values at and just inside the ends of a parameter's range.
std::vector<double> limits_of(const scree_parameter& p) {
  std::vector<double> all;
  if (p.type == SCREE_CHOICE)
    for (std::size_t k = 0; k < choices_of(p).size(); ++k) all.push_back(double(k));
  if (p.type == SCREE_BOOLEAN) all = {0, 1};
  if (p.type != SCREE_NUMBER && p.type != SCREE_INTEGER) return all;
  const double width = std::isfinite(p.maximum - p.minimum) ? p.maximum - p.minimum : 1;
  if (std::isfinite(p.minimum))
    all.push_back(p.flags & SCREE_MINIMUM_EXCLUDED ? p.minimum + 1e-3 * width : p.minimum);
  if (std::isfinite(p.maximum))
    all.push_back(p.flags & SCREE_MAXIMUM_EXCLUDED ? p.maximum - 1e-3 * width : p.maximum);
  return all;
}

bool all_finite(const ConfiguredLaw& law, const CheckedPair& pair, int dimension, double contact_time) {
  const LawUnderCheck checked{law, dimension, Passage(dimension, pair, contact_time)};
  ContactColumns contacts(LawUnderCheck::variants);
  double sum = 0;
  checked.follow(contacts, {}, 0, [&](int) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      for (int k = 0; k < SCREE_CONTACT_OUTPUT_COUNT; ++k)
        sum += 0 * contacts.output(scree_contact_output(k), 0, i);
      for (std::uint32_t k = 0; k < law.instance().history_width; ++k) sum += 0 * contacts.history(k, i);
    }
  });
  return sum == 0;
}

}  // namespace

// A limit may be refused, with the plug-in's own message; what is accepted must give finite numbers.
Checks check_limits(const Parameters& law, const CheckedPair& pair, int dimension) {
  const ConfiguredLaw given(law, dimension, no_bounds, no_bounds);
  const double time = contact_time_of(given, pair, dimension);
  const double contact_time = time > 0 ? time : 1e-3 * pair.radius / pair.speed;
  const scree_plugin& plugin = law.plugin();
  int tried = 0, refused = 0;
  std::string faults;
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const scree_parameter& p = plugin.parameters[k];
    for (const double value : limits_of(p)) {
      std::optional<ConfiguredLaw> at_limit;
      try {
        Parameters changed = law;
        changed.set(p.key, {value});
        at_limit.emplace(changed, dimension, no_bounds, no_bounds);
      } catch (const Error&) {
        ++refused;
        continue;
      }
      ++tried;
      if (!all_finite(*at_limit, pair, dimension, contact_time))
        faults += fmt::format("{}{} = {:g}", faults.empty() ? "not finite with " : ", ", p.key, value);
    }
  }
  return {{"finite results at the limits of the parameters",
           faults.empty() ? Verdict::passed : Verdict::failed,
           faults.empty() ? fmt::format("{} tried, {} refused", tried + refused, refused) : faults}};
}

}  // namespace scree::plugin_checks
